#include "src/switches.hpp"

#include <algorithm>

namespace hawser {

void hold_switches(std::vector<KernelCells>& kernels) {
  for (KernelCells& cells : kernels)
    std::fill(cells.held.begin(), cells.held.end(), 1);
}

bool release_wrong_switches(std::vector<KernelCells>& kernels, const Mesh& mesh,
                            const State& state) {
  bool released = false;
  for (KernelCells& cells : kernels) {
    if (cells.held.empty()) continue;
    each_cell(cells, mesh, state, [&](LocalIndex cell, const CellInput& input) {
      char& held = cells.held[static_cast<std::size_t>(cell)];
      if (held == 0 || cells.kernel->on_held_branch(input)) return;
      held = 0;
      released = true;
    });
  }
  return mesh.communicator.any(released);
}

bool release_switches(std::vector<KernelCells>& kernels, const Communicator& communicator) {
  bool released = false;
  for (KernelCells& cells : kernels)
    for (char& held : cells.held) {
      released = released || held != 0;
      held = 0;
    }
  return communicator.any(released);
}

}  // namespace hawser
