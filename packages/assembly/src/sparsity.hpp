#pragma once
// The matrix's graph in compressed rows, from the kernels' cells.
#include <vector>

#include "src/kernel_cells.hpp"

namespace hawser {

struct Sparsity {
  std::vector<std::size_t> row_begin;  ///< owned rows + 1
  std::vector<LocalIndex> columns;     ///< local, ascending within a row

  /// Place of (row, column) in `columns`; -1 when it is not there.
  int find(LocalIndex row, LocalIndex column) const;
};

/// `extra` are further (row, column) pairs; every owned row gets its diagonal.
Sparsity find_sparsity(LocalIndex owned_rows, const std::vector<KernelCells>& kernels,
                       const std::vector<std::pair<LocalIndex, LocalIndex>>& extra);

/// Fills KernelCells::positions.
void find_positions(const Sparsity& sparsity, KernelCells& cells);

}  // namespace hawser
