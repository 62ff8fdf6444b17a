#include "solid.hpp"

#include "hawser/physics/formula_property.hpp"
#include "hawser/physics/module_registry.hpp"
#include "solid_kernel.hpp"
#include "surface_load_kernel.hpp"

namespace hawser {
namespace {

struct Load : SurfaceLoad {
  Domain on;

  static Spec<Load> spec() {
    using P = Load;
    return Spec<P>("load", "A load on the surface of the body.")
        .attribute("on", &P::on, required(), "Boundary regions.")
        .attribute(
            "traction", &P::traction, "N/m^2", any() && length(2) && absent("none"),
            "Force per area of the undeformed surface, whose direction stays: two numbers or "
            "expressions of x y z (moved), X Y Z (reference), t.")
        .attribute("pressure", &P::pressure, "Pa", any() && length(1) && absent("none"),
                   "Pushes against the moved surface: a number or an expression of x y z (moved), "
                   "X Y Z (reference), t.")
        .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
          if (p.traction.empty() && p.pressure.empty())
            diagnostics.error(where, "<load> has neither a traction nor a pressure");
        });
  }
};

struct Solid : SolidProperties {
  Domain region;
  FieldExpressions density, young, body_force;
  std::vector<Load> loads;

  static Spec<Solid> spec() {
    using P = Solid;
    return Spec<P>(
               "solid",
               "Elastic body under large deformations, total Lagrangian; in the plane its strain "
               "across the plane is zero and forces are per metre of depth. Where it meets a "
               "flow the two share their velocity.")
        .source("packages/modules/solid/theory.md")
        .attribute("region", &P::region, required(), "Regions of the body.")
        .choice("law", &P::law,
                {{"st-venant-kirchhoff", ElasticLaw::st_venant_kirchhoff},
                 {"neo-hookean", ElasticLaw::neo_hookean}},
                "Linear in the Green-Lagrange strain, for small strains; or compressible "
                "neo-Hookean, which resists being pressed flat.")
        .attribute(
            "density", &P::density, "kg/m^3",
            positive() && length(1) && absent("what other modules supply"),
            "Mass per reference volume: a number or, as Young's modulus and the body force, an "
            "expression of place, time, fields and their derivatives.")
        .attribute("young-modulus", &P::young, "Pa",
                   positive() && length(1) && absent("what other modules supply"),
                   "Young's modulus E; of shear modulus G it is 2 G (1 + Poisson's ratio).")
        .attribute(
            "poisson-ratio", &P::poisson, "1", between(0, 0.49),
            "Poisson's ratio. Near 0.5 linear elements lock; quadratic ones do up to 0.4 without.")
        .attribute("body-force", &P::body_force, "m/s^2", any() && length(2) && absent("none"),
                   "Body force per unit mass: two numbers or expressions of x y z (moved), X Y Z "
                   "(reference), t, fields and their derivatives.")
        .attribute("damping", &P::damping, "1/s", non_negative(),
                   "External damping force per mass and velocity.")
        .attribute("viscosity", &P::viscosity, "Pa s", non_negative(),
                   "Internal damping: stress per rate of the Green-Lagrange strain.")
        .children(&P::loads);
  }
};

PhysicsModule make_solid(const Solid& deck) {
  PhysicsModule module{"solid", "structure", {}, {}};
  auto constants = give({{property::density, deck.density},
                         {property::young_modulus, deck.young},
                         {property::body_force<2>, deck.body_force}},
                        deck.region, 2, module.supplies);
  module.kernels.push_back(
      std::make_unique<SolidKernel<2>>(deck.region, deck, std::move(constants)));
  for (const Load& load : deck.loads)
    module.kernels.push_back(std::make_unique<SurfaceLoadKernel<2>>(Domain::facets(load.on), load));
  return module;
}

}  // namespace

void register_solid(ModuleRegistry& registry) { registry.add<Solid>(make_solid); }

}  // namespace hawser
