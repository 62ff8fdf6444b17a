#pragma once
#include <vector>

#include "hawser/algebra/block_system.hpp"
#include "hawser/assembly/governance.hpp"
#include "src/kernel_cells.hpp"

namespace hawser {

/// The owned rows by the block they belong to and by field. Every rank lists the same blocks in the
/// same order, also those of which it has no row; blocks without any row are left out. The unknowns
/// that place nodes have the shortest edge of the cells there as their size. Collective.
std::vector<Block> name_blocks(const DofMap& dofs, const Governance& governance,
                               const std::vector<KernelCells>& kernels);

}  // namespace hawser
