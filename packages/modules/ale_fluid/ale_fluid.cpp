#include "ale_fluid.hpp"

#include "fluid_kernel.hpp"
#include "hawser/physics/formula_property.hpp"
#include "hawser/physics/module_registry.hpp"
#include "outflow_kernel.hpp"
#include "taylor_hood_kernel.hpp"

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
  enum class Elements { stabilised, taylor_hood } elements = Elements::stabilised;
  double grad_div = 0;  // Pa s
  std::vector<Outflow> outflows;

  static Spec<AleFluid> spec() {
    using P = AleFluid;
    return Spec<P>("ale-fluid", "Incompressible Navier-Stokes flow on a moving mesh.")
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
        .choice(
            "elements", &P::elements,
            {{"stabilised", Elements::stabilised}, {"taylor-hood", Elements::taylor_hood}},
            "Linear velocity and pressure with SUPG, PSPG and LSIC stabilisation, or Taylor and "
            "Hood's: quadratic velocity, linear pressure, no stabilisation. A mesh that moves "
            "then needs <field name=\"displacement\" basis=\"P2\"/> where a structure moves it.")
        .attribute(
            "grad-div", &P::grad_div, "Pa s", non_negative(),
            "Of Taylor and Hood's elements: this times the divergence is added to the stress, "
            "which keeps volumes at small viscosity.")
        .children(&P::outflows)
        .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
          if (p.grad_div > 0 && p.elements == Elements::stabilised)
            diagnostics.error(where,
                              "grad-div belongs to elements=\"taylor-hood\"; the stabilised ones "
                              "have a term of that kind already");
        });
  }
};

PhysicsModule make_ale_fluid(const AleFluid& deck) {
  PhysicsModule module{"ale-fluid", "fluid", {}, {}};
  std::vector<PropertyConstant> constants = give({{property::density, deck.density},
                                                  {property::viscosity, deck.viscosity},
                                                  {property::eddy_viscosity, {}},
                                                  {property::body_force<2>, deck.body_force}},
                                                 deck.region, 2, module.supplies);
  if (deck.elements == AleFluid::Elements::taylor_hood)
    module.kernels.push_back(
        std::make_unique<TaylorHoodKernel<2>>(deck.region, constants, deck.grad_div));
  else
    module.kernels.push_back(std::make_unique<FluidKernel<2>>(deck.region, constants));
  constants.resize(OutflowKernel<2>::properties.size());  // the first ones
  for (const Outflow& outflow : deck.outflows)
    module.kernels.push_back(std::make_unique<OutflowKernel<2>>(
        Domain::facets(outflow.on), constants,
        OutflowTraction{outflow.pressure, outflow.keeps_poiseuille, outflow.backflow}));
  return module;
}

}  // namespace

void register_ale_fluid(ModuleRegistry& registry) { registry.add<AleFluid>(make_ale_fluid); }

}  // namespace hawser
