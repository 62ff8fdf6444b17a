#pragma once
// Terms of the energy balance, summed over kernels and cells.
#include <vector>

#include "src/kernel_cells.hpp"

namespace hawser {

class EnergySums {
 public:
  EnergySums() = default;
  /// Terms of one name and kind become one.
  explicit EnergySums(const std::vector<KernelCells>& kernels);

  const std::vector<EnergyTerm>& terms() const { return terms_; }

  using Evaluate = void (Kernel::*)(const CellInput&, double*) const;
  /// Per term, each cell counted once over all ranks. Collective.
  std::vector<double> sum(const std::vector<KernelCells>& kernels, const Mesh& mesh,
                          const State& state, Evaluate evaluate) const;

 private:
  std::vector<EnergyTerm> terms_;
  std::vector<std::vector<std::size_t>> places_;  ///< per kernel and term of its own: in terms_
};

}  // namespace hawser
