#pragma once
// What the cells of one kernel remember from one accepted step to the next
// (Kernel::memory_per_cell). Every rank that holds a cell remembers the same for it: no
// communication is needed.
#include <string>
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

struct CellMemory {
  std::string name;                ///< of the kernel, as a checkpoint calls it
  const Region* region = nullptr;  ///< the kernel's cells
  int per_cell = 0;
  /// [cell of the region][per_cell], what residuals read: it stays during a step and all that is
  /// evaluated after its end, so that reports see the equations that were solved.
  std::vector<double> accepted;
  std::vector<double> next;  ///< the same after the last accepted step; read from the next step on
};

}  // namespace hawser
