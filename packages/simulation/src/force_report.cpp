#include "src/force_report.hpp"

#include <cmath>

#include "hawser/physics/field_use.hpp"
#include "src/look_up.hpp"

namespace hawser {

ForceReport::ForceReport(const Assembler& assembler, const std::vector<PhysicsModule>& modules,
                         const ForceDeck& deck, Diagnostics& diagnostics)
    : assembler_(assembler), deck_(deck) {
  const DofMap& dofs = assembler.dofs();
  const Region* const region = find_region(dofs.mesh(), deck.on, diagnostics);
  const int velocity = find_field(dofs, {field_name::velocity, deck.on.location}, diagnostics);
  if (region != nullptr && velocity >= 0)
    for (const LocalIndex row : dofs.region_rows(velocity, *region))
      if (row < dofs.owned()) rows_.push_back(row);
  if (deck.module.value == "all") return;
  std::vector<std::string> names = {"all"};
  for (std::size_t m = 0; m < modules.size(); ++m) {
    names.push_back(modules[m].name);
    if (modules[m].name == deck.module.value) module_ = static_cast<int>(m);
  }
  if (module_ == Assembler::all_modules)
    diagnostics.error(deck.module.location, "the deck has no module '" + deck.module.value +
                                                "'; it has " + listed(names) +
                                                did_you_mean(deck.module.value, names));
}

Force ForceReport::measure(const State& state, const std::vector<double>& reactions) const {
  std::vector<double> residual, magnitude;
  if (module_ != Assembler::all_modules) assembler_.residual(state, residual, magnitude, module_);
  const std::vector<double>& rows = module_ == Assembler::all_modules ? reactions : residual;
  const double sign = module_ == Assembler::all_modules ? 1 : -1;
  double force[2] = {0, 0};
  for (const LocalIndex row : rows_)
    for (int j = 0; j < 2; ++j)
      force[j] += sign * rows[static_cast<std::size_t>(row + j)];
  MPI_Allreduce(MPI_IN_PLACE, force, 2, MPI_DOUBLE, MPI_SUM,
                assembler_.dofs().mesh().communicator.mpi());
  const double length = std::hypot(deck_.axis[0], deck_.axis[1]);
  Force result;
  result.along = (force[0] * deck_.axis[0] + force[1] * deck_.axis[1]) / length;
  result.across = (-force[0] * deck_.axis[1] + force[1] * deck_.axis[0]) / length;
  result.magnitude = std::hypot(force[0], force[1]);
  return result;
}

}  // namespace hawser
