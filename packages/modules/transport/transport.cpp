#include "transport.hpp"

#include <list>

#include "hawser/physics/formula_property.hpp"
#include "hawser/physics/module_registry.hpp"
#include "transport_kernel.hpp"

namespace hawser {
namespace {

constexpr const char* formulas_too =
    " A number or an expression of place, time, fields and their derivatives.";

struct HeatTransport {
  Domain region;
  FieldExpressions capacity, conductivity, source;
  double turbulent_number = 0.9;

  static Spec<HeatTransport> spec() {
    using P = HeatTransport;
    return Spec<P>("heat-transport", "Heat, carried by the flow and conducted: field temperature.")
        .source("packages/modules/transport/theory.md")
        .attribute("region", &P::region, required(), "Regions that conduct.")
        .attribute("capacity", &P::capacity, "J/(m^3 K)",
                   positive() && length(1) && absent("what other modules supply"),
                   std::string("Heat per volume, density times specific heat.") + formulas_too)
        .attribute("conductivity", &P::conductivity, "W/(m K)",
                   positive() && length(1) && absent("what other modules supply"),
                   std::string("Of Fourier's law.") + formulas_too)
        .attribute("source", &P::source, "W/m^3", any() && length(1) && absent("none"),
                   std::string("Heat set free per volume.") + formulas_too)
        .attribute("turbulent-prandtl-number", &P::turbulent_number, "1", positive(),
                   "Eddy viscosity over eddy diffusivity of heat.");
  }
};

struct ScalarTransport {
  Domain region;
  std::string field = "tracer";
  std::string unit = "1";
  FieldExpressions diffusivity, source, decay;
  double turbulent_number = 0.7;

  static Spec<ScalarTransport> spec() {
    using P = ScalarTransport;
    return Spec<P>("scalar-transport",
                   "A scalar, such as a dye or a salt, carried by the flow, spread and decaying.")
        .source("packages/modules/transport/theory.md")
        .attribute("region", &P::region, required(), "Regions that it fills.")
        .attribute("field", &P::field, "Name of the field; every such module has its own.")
        .attribute("unit", &P::unit, "Of the field.")
        .attribute("diffusivity", &P::diffusivity, "m^2/s",
                   non_negative() && length(1) && absent("what other modules supply"),
                   std::string("Of Fick's law.") + formulas_too)
        .attribute("source", &P::source, "as the field, per s",
                   any() && length(1) && absent("none"),
                   std::string("What is set free, in the field's unit per second.") + formulas_too)
        .attribute("decay", &P::decay, "1/s", non_negative() && length(1) && absent("none"),
                   std::string("Rate at which it decays.") + formulas_too)
        .attribute("turbulent-schmidt-number", &P::turbulent_number, "1", positive(),
                   "Eddy viscosity over eddy diffusivity of the scalar.");
  }
};

PhysicsModule make_heat(const HeatTransport& deck) {
  using Heat = HeatQuantity;
  PhysicsModule module{"heat-transport", "heat", {}, {}};
  auto constants = give({{Heat::capacity, deck.capacity},
                         {Heat::conductivity, deck.conductivity},
                         {Heat::source, deck.source}},
                        deck.region, 2, module.supplies);
  module.kernels.push_back(std::make_unique<TransportKernel<2, Heat>>(
      deck.region, std::move(constants), deck.turbulent_number));
  return module;
}

PhysicsModule make_scalar(const ScalarTransport& deck) {
  using Scalar = ScalarQuantity;
  PhysicsModule module{"scalar-transport", deck.field, {}, {}};
  const std::pair<PropertyUse, FieldExpressions> in_deck[] = {
      {Scalar::capacity, {}},
      {Scalar::conductivity, deck.diffusivity},
      {Scalar::source, deck.source},
      {Scalar::decay, deck.decay}};
  std::vector<GivenProperty> given;
  std::list<std::string> names;
  for (const auto& [use, formulas] : in_deck) {
    names.push_back(scalar_property(deck.field, use));
    given.push_back({use, formulas});
    given.back().property.name = names.back().c_str();
  }
  auto kernel = std::make_unique<TransportKernel<2, Scalar>>(
      deck.region, give(given, deck.region, 2, module.supplies), deck.turbulent_number);
  kernel->name_scalar(deck.field, deck.unit);
  module.kernels.push_back(std::move(kernel));
  return module;
}

}  // namespace

void register_transport(ModuleRegistry& registry) {
  registry.add<HeatTransport>(make_heat);
  registry.add<ScalarTransport>(make_scalar);
}

}  // namespace hawser
