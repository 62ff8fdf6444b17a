#include "ale_fluid.hpp"

#include <algorithm>

#include "fluid_kernel.hpp"
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
  double density = 1000;
  double viscosity = 1;
  Expressions body_force = {0, 0};
  std::vector<Outflow> outflows;

  static Spec<AleFluid> spec() {
    using P = AleFluid;
    return Spec<P>("ale-fluid",
                   "Incompressible Navier-Stokes flow on a moving mesh; linear velocity and "
                   "pressure with "
                   "SUPG, PSPG and LSIC stabilisation.")
        .source("packages/modules/ale_fluid/theory.md")
        .attribute("region", &P::region, required(), "Regions that the fluid fills.")
        .attribute("density", &P::density, "kg/m^3", positive(), "Mass density.")
        .attribute("viscosity", &P::viscosity, "Pa s", required() && positive(),
                   "Dynamic viscosity (density times the kinematic, or eddy, viscosity).")
        .attribute("body-force", &P::body_force, "m/s^2", any() && length(2),
                   "Body force per unit mass: two numbers or expressions of x y z (moved), X Y Z "
                   "(reference), t.")
        .children(&P::outflows);
  }
};

std::unique_ptr<Kernel> make_fluid_kernel(const AleFluid& deck) {
  const FluidProperties fluid{deck.density, deck.viscosity};
  const Expressions& force = deck.body_force;
  if (std::all_of(force.begin(), force.end(), [](const auto& f) { return f.is_constant(); }))
    return std::make_unique<FluidKernel<2, UniformForce<2>>>(
        deck.region, fluid, UniformForce<2>{{force[0]({}), force[1]({})}});
  return std::make_unique<FluidKernel<2, VaryingForce>>(deck.region, fluid, VaryingForce{force});
}

PhysicsModule make_ale_fluid(const AleFluid& deck) {
  PhysicsModule module{"ale-fluid", "fluid", {}, {}};
  module.kernels.push_back(make_fluid_kernel(deck));
  for (const Outflow& outflow : deck.outflows)
    module.kernels.push_back(std::make_unique<OutflowKernel>(
        Domain::facets(outflow.on),
        OutflowProperties{outflow.pressure, deck.density, deck.viscosity, outflow.keeps_poiseuille,
                          outflow.backflow}));
  return module;
}

}  // namespace

void register_ale_fluid(ModuleRegistry& registry) { registry.add<AleFluid>(make_ale_fluid); }

}  // namespace hawser
