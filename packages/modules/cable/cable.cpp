#include "cable.hpp"

#include <cmath>

#include "axial_kernel.hpp"
#include "bending_kernel.hpp"
#include "drag_kernel.hpp"
#include "hawser/physics/module_registry.hpp"
#include "hawser/physics/vector_parameters.hpp"
#include "load_kernel.hpp"

namespace hawser {
namespace {

struct Drag : DragProperties {
  Located<Expressions> current;

  static Spec<Drag> spec() {
    using P = Drag;
    return Spec<P>("drag",
                   "Load of a given current on a cable without a flow around it, by drag "
                   "coefficients; diameter and length are those of the unstretched cable.")
        .attribute("current", &P::current, "m/s", required() && any(),
                   "A number or expression per direction, of x y z (moved), X Y Z (reference), t.")
        .attribute("diameter", &P::diameter, "m", required() && positive(), "Of the cable.")
        .attribute("density", &P::density, "kg/m^3", positive(), "Of the water.")
        .attribute("normal-coefficient", &P::normal, "1", non_negative(),
                   "Of rho Cn D |u_n| u_n / 2; 1.2 is a smooth cylinder at Reynolds numbers of 1e3 "
                   "to 2e5.")
        .attribute("tangential-coefficient", &P::tangential, "1", non_negative(),
                   "Of rho Ct pi D |u_t| u_t / 2.")
        .attribute("added-mass-coefficient", &P::added_mass, "1", non_negative(),
                   "Added mass across the cable relative to the displaced mass; 1 is a cylinder in "
                   "ideal flow.");
  }
};

struct PointLoad {
  Domain on;
  Located<Expressions> force;

  static Spec<PointLoad> spec() {
    using P = PointLoad;
    return Spec<P>("point-load", "A force at a point of the cable.")
        .attribute("on", &P::on, required(), "Point regions.")
        .attribute("force", &P::force, "N", required() && any(),
                   "A number or expression per direction, of x y z (moved), X Y Z (reference), t.");
  }
};

struct Cable : CableProperties {
  Domain region;
  Located<std::vector<double>> gravity;
  std::optional<double> submerged_weight;
  std::vector<std::string> clamped;
  Located<Expressions> load;
  std::optional<Drag> drag;
  std::vector<PointLoad> point_loads;

  static Spec<Cable> spec() {
    using P = Cable;
    return Spec<P>("cable",
                   "Total Lagrangian cable with axial and bending stiffness that carries no "
                   "compression, in the plane or in space; in a flow in the plane all quantities "
                   "are per metre of depth.")
        .source("packages/modules/cable/theory.md")
        .attribute("region", &P::region, required(),
                   "Line regions of the cable; where two of them meet end to end it goes on.")
        .attribute("mass-per-length", &P::mass, "kg/m", non_negative(),
                   "Inertia per length; 0 for a line that has only that of the water around it.")
        .attribute("axial-stiffness", &P::axial_stiffness, "N", positive(), "Axial stiffness EA.")
        .attribute("bending-stiffness", &P::bending_stiffness, "N m^2", non_negative(),
                   "EI; with 0 the tail of a towed cable flaps under any refinement.")
        .attribute("clamped", &P::clamped, absent("none"),
                   "Point regions where the direction of the cable stays the initial one; "
                   "elsewhere it is hinged.")
        .attribute("gravity", &P::gravity, "m/s^2", any() && absent("none"),
                   "Acceleration per direction; the weight is this times mass-per-length, unless "
                   "submerged-weight is given.")
        .attribute("submerged-weight", &P::submerged_weight, "N/m",
                   any() && absent("by gravity and mass-per-length"),
                   "Weight per length in the surrounding fluid, along gravity: mass less displaced "
                   "mass, times g; negative for a cable that floats up.")
        .attribute("load", &P::load, "N/m", any() && absent("none"),
                   "Further force per reference length: a number or expression per direction, of x "
                   "y z (moved), X Y Z (reference), t.")
        .attribute("damping", &P::damping, "N s/m^2", non_negative(),
                   "External damping force per length and velocity.")
        .attribute("axial-damping", &P::axial_damping, "N s", non_negative(),
                   "Internal damping: tension per rate of strain.")
        .attribute("slack-width", &P::slack_width, "1", positive(),
                   "Strain over which the tension is switched off smoothly in compression.")
        .attribute("compressive-ratio", &P::compressive_ratio, "1", between(0, 1),
                   "Stiffness kept in compression, relative to EA.")
        .child(&P::drag)
        .children(&P::point_loads)
        .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
          if (p.submerged_weight && p.gravity.value.empty())
            diagnostics.error(where, "submerged-weight needs gravity, which says where down is");
          if (!p.clamped.empty() && p.bending_stiffness == 0)
            diagnostics.error(where,
                              "a cable without bending-stiffness cannot be clamped: it has a hinge "
                              "everywhere");
        });
  }
};

template <int D>
PhysicsModule make_cable(const Cable& deck) {
  PhysicsModule module{"cable", "structure", {}, {}};
  module.kernels.push_back(std::make_unique<CableKernel<D>>(
      deck.region, deck, weight_in_water<D>(deck.gravity, deck.submerged_weight, deck.mass)));
  if (!deck.load.value.empty())
    module.kernels.push_back(std::make_unique<CableLoadKernel<D>>(deck.region, deck.load.value));
  for (const PointLoad& load : deck.point_loads)
    module.kernels.push_back(std::make_unique<PointLoadKernel<D>>(load.on, load.force.value));
  if (deck.drag)
    module.kernels.push_back(
        std::make_unique<CableDragKernel<D>>(deck.region, *deck.drag, deck.drag->current.value));
  if (deck.bending_stiffness == 0) return module;
  module.kernels.push_back(
      std::make_unique<BendingKernel<D>>(Domain::patches(deck.region), deck.bending_stiffness));
  for (const std::string& point : deck.clamped)
    module.kernels.push_back(
        std::make_unique<ClampKernel<D>>(Domain::ends(deck.region, point), deck.bending_stiffness));
  return module;
}

PhysicsModule make_cable_in(const Cable& deck, const ModuleContext& context,
                            Diagnostics& diagnostics) {
  const auto check_length = [&](const auto& vector, const std::string& name) {
    check_components(vector, name, context.dimension, diagnostics);
  };
  check_length(deck.gravity, "gravity");
  check_length(deck.load, "load");
  if (deck.drag) check_length(deck.drag->current, "current");
  for (const PointLoad& point : deck.point_loads)
    check_length(point.force, "force");
  if (!diagnostics.ok()) return {};
  return context.dimension == 3 ? make_cable<3>(deck) : make_cable<2>(deck);
}

}  // namespace

void register_cable(ModuleRegistry& registry) { registry.add<Cable>(make_cable_in); }

}  // namespace hawser
