#pragma once
#include "src/kernel_cells.hpp"

namespace hawser {

/// Remembers the first cell of an element loop that could not be evaluated.
struct CellFailure {
  CellStatus status = CellStatus::ok;
  const KernelCells* cells = nullptr;
  LocalIndex cell = 0;

  void note(CellStatus found, const KernelCells& where, LocalIndex which) {
    if (status != CellStatus::ok || found == CellStatus::ok) return;
    status = found;
    cells = &where;
    cell = which;
  }

  /// SolveError on all ranks when any of them met such a cell. Collective.
  void throw_together(const Mesh& mesh, const State& state) const;
};

}  // namespace hawser
