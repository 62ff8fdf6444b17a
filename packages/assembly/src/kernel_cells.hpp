#pragma once
// A kernel on the cells of this rank, with every index it needs resolved beforehand.
#include <vector>

#include "hawser/assembly/governance.hpp"
#include "hawser/fields/state.hpp"

namespace hawser {

struct KernelCells {
  const Kernel* kernel = nullptr;
  const Region* region = nullptr;
  int module = 0;
  std::vector<int>
      fields;  ///< per field of the kernel: index in the DofMap; -1 when nobody solves it
  std::vector<int> first;  ///< first unknown of each field on a cell; one more entry: all unknowns
  std::vector<LocalIndex> rows;  ///< [cell][unknown]: local row to read from; -1 reads zero
  std::vector<char>
      writes;              ///< [cell][unknown]: 1 when the contribution counts (owned and governed)
  std::vector<char> adds;  ///< [cell][unknown]: 1 when owned and the kernel adds to or governs it
  std::vector<int> positions;  ///< [cell][unknown][unknown]: place in the matrix; -1 when dropped

  /// [cell]: 1 where the branch of the accepted state is held; empty when the law does not switch.
  std::vector<char> held;

  int unknowns() const { return first.back(); }
};

/// PluginError when the kernel is written for other cells than its region has, DeckError when it
/// cannot work with a field's basis.
KernelCells resolve(const DofMap& dofs, const Governance& governance, const PhysicsModule& module,
                    Kernel& kernel, int module_index);

/// Gathers the nodal arrays of one cell after another without allocating.
class CellGatherer {
 public:
  CellGatherer(const KernelCells& cells, const Mesh& mesh, const State& state);
  const CellInput& gather(LocalIndex cell);

 private:
  const KernelCells& cells_;
  const Mesh& mesh_;
  const State& state_;
  std::vector<double> value_, rate_, accepted_, slope_, partner_, coordinates_;
  std::vector<FieldOnCell> fields_;
  CellInput input_;
};

/// Calls visit(cell, input) for every cell of this rank, in order.
template <class Visit>
void each_cell(const KernelCells& cells, const Mesh& mesh, const State& state, Visit&& visit) {
  CellGatherer gatherer(cells, mesh, state);
  for (LocalIndex cell = 0; cell < cells.region->size(); ++cell)
    visit(cell, gatherer.gather(cell));
}

}  // namespace hawser
