#pragma once
// A kernel on the cells of this rank, with every index it needs resolved beforehand.
#include <string>
#include <vector>

#include "hawser/assembly/cell_memory.hpp"
#include "hawser/assembly/governance.hpp"
#include "hawser/fields/state.hpp"

namespace hawser {

struct KernelCells {
  const Kernel* kernel = nullptr;
  const Region* region = nullptr;
  int module = 0;
  std::string stranger;  ///< the module's full name where it is of a plug-in
  std::vector<int>
      fields;  ///< per field of the kernel: index in the DofMap; -1 when nobody solves it
  std::vector<int> first;  ///< first unknown of each field on a cell; one more entry: all unknowns
  std::vector<LocalIndex> rows;  ///< [cell][unknown]: local row to read from; -1 reads zero
  std::vector<char>
      writes;              ///< [cell][unknown]: 1 when the contribution counts (owned and governed)
  std::vector<char> adds;  ///< [cell][unknown]: 1 when owned and the kernel adds to or governs it
  std::vector<int> positions;  ///< [cell][unknown][unknown]: place in the matrix; -1 when dropped

  std::vector<int> levels;  ///< the fields among them that have a level
  /// [cell][connection of the kernel's properties]: 1 where that source holds.
  std::vector<char> supplied;
  CellMemory memory;  ///< once made; nothing for most kernels
  /// [cell]: 1 where the branch of the accepted state is held; empty when the law does not switch.
  std::vector<char> held;

  int unknowns() const { return first.back(); }
  bool has_level() const { return !levels.empty(); }
  /// Where the memory of a cell begins.
  std::size_t memory_of(LocalIndex cell) const {
    return static_cast<std::size_t>(cell) * static_cast<std::size_t>(memory.per_cell);
  }
};

/// PluginError when the kernel is written for other cells than its region has, DeckError when it
/// cannot work with a field's basis.
KernelCells resolve(const DofMap& dofs, const Governance& governance, const PhysicsModule& module,
                    Kernel& kernel, int module_index);

/// Zero everywhere, as at the start of a run.
void make_memory(KernelCells& cells, std::string name);

/// Gathers the nodal arrays of one cell after another without allocating.
class CellGatherer {
 public:
  CellGatherer(const KernelCells& cells, const Mesh& mesh, const State& state);
  const CellInput& gather(LocalIndex cell);
  /// The cell gathered last, its fields that have a level without their means there.
  const CellInput& off_level();

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
