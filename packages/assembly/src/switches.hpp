#pragma once
// Where laws that switch keep the branch of the accepted state (Kernel::switches). A cell is asked
// on every rank that holds it, with the same values: all of them decide alike.
#include <vector>

#include "src/kernel_cells.hpp"

namespace hawser {

void hold_switches(std::vector<KernelCells>& kernels);
/// Collective.
bool release_wrong_switches(std::vector<KernelCells>& kernels, const Mesh& mesh,
                            const State& state);
/// Collective.
bool release_switches(std::vector<KernelCells>& kernels, const Communicator& communicator);

}  // namespace hawser
