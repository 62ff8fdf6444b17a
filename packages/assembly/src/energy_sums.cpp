#include "src/energy_sums.hpp"

#include <algorithm>
#include <string_view>

namespace hawser {

EnergySums::EnergySums(const std::vector<KernelCells>& kernels) {
  for (const KernelCells& cells : kernels) {
    places_.emplace_back();
    for (const EnergyTerm& term : cells.kernel->energy_terms()) {
      const auto same = std::find_if(terms_.begin(), terms_.end(), [&](const EnergyTerm& known) {
        return known.kind == term.kind && std::string_view(known.name) == term.name;
      });
      places_.back().push_back(static_cast<std::size_t>(same - terms_.begin()));
      if (same == terms_.end()) terms_.push_back(term);
    }
  }
}

std::vector<double> EnergySums::sum(const std::vector<KernelCells>& kernels, const Mesh& mesh,
                                    const State& state, Evaluate evaluate) const {
  std::vector<double> sums(terms_.size(), 0);
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    const std::vector<std::size_t>& places = places_[k];
    if (places.empty()) continue;
    const KernelCells& cells = kernels[k];
    std::vector<double> values(places.size(), 0);
    CellGatherer gatherer(cells, mesh, state);
    for (LocalIndex cell = 0; cell < cells.region->size(); ++cell) {
      if (cells.region->cell_owners[static_cast<std::size_t>(cell)] != mesh.communicator.rank())
        continue;
      (cells.kernel->*evaluate)(gatherer.gather(cell), values.data());
      for (std::size_t i = 0; i < places.size(); ++i)
        sums[places[i]] += values[i];
    }
  }
  for (double& value : sums)
    value = mesh.communicator.sum(value);
  return sums;
}

}  // namespace hawser
