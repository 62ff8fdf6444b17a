#include "src/force_report.hpp"

#include <fmt/format.h>

#include "hawser/fields/look_up.hpp"
#include "hawser/physics/field_use.hpp"
#include "hawser/report/report_name.hpp"

namespace hawser {

Spec<ForceDeck> ForceDeck::spec() {
  using P = ForceDeck;
  return Spec<P>("force",
                 "Reports the force on a region: of one module, or the support's reaction.")
      .attribute("name", &P::name, required(), "Start of the quantities' names.")
      .attribute("on", &P::on, required(), "Region whose velocity rows are summed.")
      .attribute("module", &P::module,
                 "Module whose load on the region is reported, of several of a kind the sum; all "
                 "for the reaction.")
      .attribute("axis", &P::axis, "1", any() && length(2, 3) && absent("+x"),
                 "Direction of the component called along; across is 90 degrees left, in "
                 "space the magnitude of the rest.")
      .check(check_report_name<P>);
}

ForceReport::ForceReport(const ForceDeck& deck, const ReportContext& context,
                         Diagnostics& diagnostics)
    : assembler_(context.assembler), deck_(deck) {
  const DofMap& dofs = context.dofs();
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
  if (deck.module.value != "all") choose_modules(context.modules, diagnostics);
}

void ForceReport::choose_modules(const std::vector<PhysicsModule>& modules,
                                 Diagnostics& diagnostics) {
  const std::string& wanted = deck_.module.value;
  std::vector<std::string> names = {"all"};
  for (std::size_t m = 0; m < modules.size(); ++m) {
    names.push_back(modules[m].name);
    if (modules[m].name == wanted) modules_.push_back(static_cast<int>(m));
  }
  if (modules_.empty())
    diagnostics.error(deck_.module.location, "the deck has no module '" + wanted + "'; it has " +
                                                 listed(names) + did_you_mean(wanted, names));
}

std::vector<Column> ForceReport::columns() const {
  return force_columns(deck_.name, assembler_.dofs().mesh());
}

std::vector<double> ForceReport::measure(const Step& step) {
  std::vector<double> force(deck_.axis.value.size(), 0);
  const auto add = [&](const std::vector<double>& rows, double sign) {
    for (const LocalIndex row : rows_)
      for (std::size_t j = 0; j < force.size(); ++j)
        force[j] += sign * rows[static_cast<std::size_t>(row) + j];
  };
  if (modules_.empty()) add(step.reactions, 1);
  std::vector<double> residual;
  for (const int module : modules_) {
    assembler_.residual(step.balance, residual, module);
    add(residual, -1);
  }
  MPI_Allreduce(MPI_IN_PLACE, force.data(), static_cast<int>(force.size()), MPI_DOUBLE, MPI_SUM,
                assembler_.dofs().mesh().communicator.mpi());
  return force_values(split_force(force, deck_.axis.value));
}

std::string ForceReport::closing() const {
  const std::string unit = assembler_.dofs().mesh().force_unit();
  return fmt::format("{}: along {:.6g} {}, across {:.6g} {}\n", deck_.name, values()[1], unit,
                     values()[2], unit);
}

}  // namespace hawser
