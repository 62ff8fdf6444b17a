#include "src/force_report.hpp"

#include <cmath>

#include "hawser/fields/look_up.hpp"
#include "hawser/physics/field_use.hpp"

namespace hawser {

Force split_force(const std::vector<double>& force, const std::vector<double>& axis) {
  double squared = 0, length = 0, along = 0;
  for (std::size_t j = 0; j < axis.size(); ++j) {
    squared += force[j] * force[j];
    length += axis[j] * axis[j];
    along += force[j] * axis[j];
  }
  length = std::sqrt(length);
  Force result{along / length, 0, std::sqrt(squared)};
  if (axis.size() == 2) {
    result.across = (-force[0] * axis[1] + force[1] * axis[0]) / length;
    return result;
  }
  double across = 0;
  for (std::size_t j = 0; j < axis.size(); ++j)
    across += std::pow(force[j] - result.along * axis[j] / length, 2);
  result.across = std::sqrt(across);
  return result;
}

ForceReport::ForceReport(const Assembler& assembler, const std::vector<PhysicsModule>& modules,
                         const ForceDeck& deck, Diagnostics& diagnostics)
    : assembler_(assembler), deck_(deck) {
  const DofMap& dofs = assembler.dofs();
  const auto dimension = static_cast<std::size_t>(dofs.mesh().dimension);
  if (deck_.axis.value.empty()) {
    deck_.axis.value.assign(dimension, 0);
    deck_.axis.value[0] = 1;
  } else if (deck_.axis.value.size() != dimension) {
    diagnostics.error(deck.axis.location, "the axis of force '" + deck.name + "' has " +
                                              std::to_string(deck.axis.value.size()) +
                                              " components, the mesh " + std::to_string(dimension));
  }
  const Region* const region = find_region(dofs.mesh(), deck.on, diagnostics);
  const int velocity = find_field(dofs, {field_name::velocity, deck.on.location}, diagnostics);
  if (region != nullptr && velocity >= 0)
    for (const LocalIndex row : dofs.region_rows(velocity, *region))
      if (row < dofs.owned()) rows_.push_back(row);
  if (deck.module.value == "all") return;
  std::vector<std::string> names = {"all"};
  for (std::size_t m = 0; m < modules.size(); ++m) {
    names.push_back(modules[m].name);
    if (modules[m].name == deck.module.value) modules_.push_back(static_cast<int>(m));
  }
  if (modules_.empty())
    diagnostics.error(deck.module.location, "the deck has no module '" + deck.module.value +
                                                "'; it has " + listed(names) +
                                                did_you_mean(deck.module.value, names));
}

Force ForceReport::measure(const State& state, const std::vector<double>& reactions) const {
  std::vector<double> force(deck_.axis.value.size(), 0), residual, magnitude;
  const auto add = [&](double sign, const std::vector<double>& values) {
    for (const LocalIndex row : rows_)
      for (std::size_t j = 0; j < force.size(); ++j)
        force[j] += sign * values[static_cast<std::size_t>(row) + j];
  };
  if (modules_.empty()) add(1, reactions);
  for (const int module : modules_) {
    assembler_.residual(state, residual, magnitude, module);
    add(-1, residual);
  }
  MPI_Allreduce(MPI_IN_PLACE, force.data(), static_cast<int>(force.size()), MPI_DOUBLE, MPI_SUM,
                assembler_.dofs().mesh().communicator.mpi());
  return split_force(force, deck_.axis.value);
}

}  // namespace hawser
