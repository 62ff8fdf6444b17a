#include "ale_fluid.hpp"

#include "fluid_kernel.hpp"
#include "hawser/physics/formula_property.hpp"
#include "hawser/physics/module_registry.hpp"
#include "outflow_kernel.hpp"

namespace hawser {
namespace {

struct Outflow {
  Domain on;
  double pressure = 0;
  double backflow = 0;
  bool keeps_poiseuille = true;

  static Spec<Outflow> spec() {
    using P = Outflow;
    return Spec<P>("outflow", "A boundary through which the fluid leaves.")
        .attribute("on", &P::on, required(), "Boundary regions.")
        .choice("kind", &P::keeps_poiseuille, required(),
                {{"pressure", true}, {"traction-free", false}},
                "What the outside does: \"pressure\" is t = -p0 n + mu (grad v)^T n, which leaves "
                "a developed "
                "channel flow undisturbed; \"traction-free\" is t = -p0 n, a free surface.")
        .attribute("pressure", &P::pressure, "Pa", any(), "Outside pressure p0.")
        .attribute(
            "backflow", &P::backflow, "1", between(0, 1),
            "Share of the momentum flux that resists where fluid flows back in; 0.5 is ample.");
  }
};

struct AleFluid {
  Domain region;
  FieldExpressions density = {1000};
  FieldExpressions viscosity, body_force;
  std::vector<Outflow> outflows;

  static Spec<AleFluid> spec() {
    using P = AleFluid;
    return Spec<P>("ale-fluid",
                   "Incompressible Navier-Stokes flow on a moving mesh; linear velocity and "
                   "pressure with "
                   "SUPG, PSPG and LSIC stabilisation.")
        .source("packages/modules/ale_fluid/theory.md")
        .attribute("region", &P::region, required(), "Regions that the fluid fills.")
        .attribute("density", &P::density, "kg/m^3", positive() && length(1), "Mass density.")
        .attribute("viscosity", &P::viscosity, "Pa s",
                   positive() && length(1) && absent("what other modules supply"),
                   "Dynamic viscosity (density times the kinematic one). A number or, as density "
                   "and body force, an expression of place, time, fields (temperature, velocity_x) "
                   "and their derivatives (dx(velocity_y)).")
        .attribute("body-force", &P::body_force, "m/s^2", any() && length(2) && absent("none"),
                   "Body force per unit mass: two numbers or expressions of x y z (moved), X Y Z "
                   "(reference), t, fields and their derivatives.")
        .children(&P::outflows);
  }
};

PhysicsModule make_ale_fluid(const AleFluid& deck) {
  PhysicsModule module{"ale-fluid", "fluid", {}, {}};
  std::vector<PropertyConstant> constants = give({{property::density, deck.density},
                                                  {property::viscosity, deck.viscosity},
                                                  {property::eddy_viscosity, {}},
                                                  {property::body_force<2>, deck.body_force}},
                                                 deck.region, 2, module.supplies);
  module.kernels.push_back(std::make_unique<FluidKernel<2>>(deck.region, constants));
  constants.resize(OutflowKernel::properties.size());  // the first ones
  for (const Outflow& outflow : deck.outflows)
    module.kernels.push_back(std::make_unique<OutflowKernel>(
        Domain::facets(outflow.on), constants,
        OutflowTraction{outflow.pressure, outflow.keeps_poiseuille, outflow.backflow}));
  return module;
}

}  // namespace

void register_ale_fluid(ModuleRegistry& registry) { registry.add<AleFluid>(make_ale_fluid); }

}  // namespace hawser
