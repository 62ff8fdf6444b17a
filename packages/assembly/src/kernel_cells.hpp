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

  int unknowns() const { return first.back(); }
};

KernelCells resolve(const DofMap& dofs, const Governance& governance, Kernel& kernel, int module);

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

}  // namespace hawser
