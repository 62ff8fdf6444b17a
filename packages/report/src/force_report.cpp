#include "src/force_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

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
                 "Module whose load on the region is reported; all for the reaction.")
      .attribute("module-on", &P::module_on, absent("all modules of that name"),
                 "Regions of the modules that are meant, where several have the name; all of them "
                 "for the sum. Without it a note says that the load is a sum.")
      .attribute("axis", &P::axis, "1", any() && length(2, 3) && absent("+x"),
                 "Direction of the component called along; across is 90 degrees left, in "
                 "space the magnitude of the rest.")
      .check(check_report_name<P>);
}

namespace {

/// On one of these regions; on any where none is named.
bool lives_on(const PhysicsModule& module, const std::vector<std::string>& regions) {
  if (regions.empty()) return true;
  for (const auto& kernel : module.kernels)
    for (const std::string& region : kernel->domain().regions)
      if (kernel->domain().kind == Domain::Kind::cells &&
          std::find(regions.begin(), regions.end(), region) != regions.end())
        return true;
  return false;
}

}  // namespace

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
  if (region != nullptr && velocity >= 0 && !dofs.mesh().communicator.any(!rows_.empty()))
    diagnostics.error(deck.on.location, "no module solves for a velocity on region '" +
                                            deck.on.value + "': there is no force to report");
  if (deck.module.value != "all") choose_modules(context.modules, diagnostics);
  if (region != nullptr) note_a_sum(context.modules, *region, diagnostics);
}

/// A region of one module alone that another of the name meets, as in the joint of two cables,
/// could mean either; one that they share among them, such as the wall of two waters, means both.
void ForceReport::note_a_sum(const std::vector<PhysicsModule>& modules, const Region& region,
                             Diagnostics& diagnostics) const {
  if (!deck_.module_on.value.empty()) return;
  const Mesh& mesh = assembler_.dofs().mesh();
  // All cells at an owned vertex are here.
  std::set<LocalIndex> wanted(region.vertices.begin(), region.vertices.end());
  wanted.erase(wanted.lower_bound(mesh.vertices.owned), wanted.end());
  std::vector<std::string> there;
  bool one_has_all = false;
  for (const int m : modules_) {
    const PhysicsModule& module = modules[static_cast<std::size_t>(m)];
    std::set<LocalIndex> has;
    for (const auto& kernel : module.kernels)
      if (const Region* const domain = mesh.find(kernel->domain()); domain != nullptr)
        for (const LocalIndex vertex : domain->vertices)
          if (wanted.count(vertex) > 0) has.insert(vertex);
    if (!mesh.communicator.any(!has.empty())) continue;
    there.push_back(module.location.text());
    one_has_all = !mesh.communicator.any(has.size() < wanted.size()) || one_has_all;
  }
  if (there.size() > 1 && one_has_all)
    diagnostics.note(deck_.module.location,
                     "force '" + deck_.name + "' is the sum of " + std::to_string(there.size()) +
                         " modules '" + deck_.module.value + "' that meet on '" + deck_.on.value +
                         "' (" + listed(there) +
                         "); name in module-on=\"...\" the regions of those that are meant");
}

void ForceReport::choose_modules(const std::vector<PhysicsModule>& modules,
                                 Diagnostics& diagnostics) {
  const std::string& wanted = deck_.module.value;
  std::vector<std::string> names = {"all"};
  for (std::size_t m = 0; m < modules.size(); ++m) {
    names.push_back(modules[m].name);
    if (modules[m].name == wanted && lives_on(modules[m], deck_.module_on.value))
      modules_.push_back(static_cast<int>(m));
  }
  if (modules_.empty() && std::count(names.begin(), names.end(), wanted) > 0) {
    diagnostics.error(deck_.module_on.location,
                      "no module '" + wanted + "' lives on " + listed(deck_.module_on.value));
    return;
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
