#include "property.hpp"

#include "hawser/physics/formula_property.hpp"
#include "hawser/physics/module_registry.hpp"

namespace hawser {
namespace {

struct Property {
  std::string name;
  Domain region;
  FieldExpressions value;
  bool adds = false;

  static Spec<Property> spec() {
    using P = Property;
    return Spec<P>("property",
                   "Supplies a quantity that modules use at each point, such as the viscosity.")
        .source("packages/modules/property/theory.md")
        .attribute("name", &P::name, required(),
                   "What is supplied, as the modules that use it call it: density, viscosity, eddy "
                   "viscosity, body force, mesh stiffness, or a name of a plug-in's.")
        .attribute("region", &P::region, required(), "Regions of the body where it holds.")
        .attribute("value", &P::value, "as the property", required() && any(),
                   "In SI units, one expression per component: of place (x y z moved, X Y Z "
                   "reference), t, fields (temperature, velocity_x) and their derivatives "
                   "(dx(velocity_y)).")
        .attribute("adds", &P::adds,
                   "Its value is added to what others supply there; else nobody else may.");
  }
};

PhysicsModule make_property(const Property& deck, const ModuleContext& context) {
  PhysicsModule module{"property", "", {}, {}};
  module.supplies.push_back(
      {deck.region, deck.adds,
       std::make_unique<FormulaProperty>(deck.name, context.dimension, deck.value)});
  return module;
}

}  // namespace

void register_property(ModuleRegistry& registry) { registry.add<Property>(make_property); }

}  // namespace hawser
