#include "src/integral_report.hpp"

#include "hawser/base/exact_sum.hpp"
#include "hawser/fields/look_up.hpp"

namespace hawser {

Spec<IntegralDeck> IntegralDeck::spec() {
  using P = IntegralDeck;
  return Spec<P>("integral",
                 "Reports the integral of a formula over a region as it has moved: a body (per "
                 "metre of depth in the plane), a line, a boundary.")
      .attribute("name", &P::name, required(), "Name of the quantity.")
      .attribute("of", &P::of, "SI", required() && any(),
                 "A formula of place, time, fields and their derivatives, such as "
                 "velocity_x*dx(temperature); on a boundary of normal_x and normal_y, too, which "
                 "point out of the body.")
      .attribute("on", &P::on, required(), "Region.")
      .attribute("unit", &P::unit, "Unit of the result, for its name: nothing is converted.")
      .attribute("mean", &P::mean, "Divide by the region's length or area.")
      .check(check_name_and_unit<P>)
      .source("doc/decks.md");
}

IntegralReport::IntegralReport(const IntegralDeck& deck, const ReportContext& context,
                               Diagnostics& diagnostics)
    : communicator_(context.mesh().communicator), deck_(deck), instant_(context) {
  const Region* const region = find_region(context.mesh(), deck.on, diagnostics);
  if (region == nullptr) return;
  if (region->dimension == 0) {
    diagnostics.error(deck.on.location, "region '" + region->name +
                                            "' is a point, over which nothing can be integrated; a "
                                            "<probe> gives the value there");
    return;
  }
  sampling_.emplace(context.dofs(), *region, deck.of, moving_field(context.dofs()), quadrature,
                    diagnostics);
  instant_.look_at(sampling_->formula());
}

std::vector<double> IntegralReport::measure(const Step& step) {
  std::vector<double> values, sizes;
  communicator_.together([&] {
    sampling_->visit(instant_(step), [&](const RegionSampling::Sample& at) {
      values.push_back(at.weight * at.value);
      if (deck_.mean) sizes.push_back(at.weight);
    });
  });
  const double sum = exact_sum(communicator_, values);
  return {deck_.mean ? sum / exact_sum(communicator_, sizes) : sum};
}

}  // namespace hawser
