#include "src/force_report.hpp"

#include <fmt/format.h>

#include "hawser/physics/field_use.hpp"
#include "hawser/physics/vector_parameters.hpp"
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

ForceReport::ForceReport(const ForceDeck& deck, const ReportContext& context,
                         Diagnostics& diagnostics)
    : mesh_(context.mesh()),
      deck_(deck),
      loads_({deck.name,
              "force",
              {{deck.on.value}, deck.on.location},
              {field_name::velocity, deck.on.location},
              deck.module,
              deck.module_on},
             context, diagnostics) {
  const auto dimension = static_cast<std::size_t>(mesh_.dimension);
  if (deck_.axis.value.empty()) {
    deck_.axis.value.assign(dimension, 0);
    deck_.axis.value[0] = 1;
  } else {
    check_components(deck.axis, "the axis of force '" + deck.name + "'", mesh_.dimension,
                     diagnostics);
  }
}

std::vector<Column> ForceReport::columns() const { return force_columns(deck_.name, mesh_); }

std::vector<double> ForceReport::measure(const Step& step) {
  return force_values(split_force(loads_.sum(step), deck_.axis.value));
}

std::string ForceReport::closing() const {
  const std::string unit = mesh_.force_unit();
  return fmt::format("{}: along {:.6g} {}, across {:.6g} {}\n", deck_.name, values()[1], unit,
                     values()[2], unit);
}

}  // namespace hawser
