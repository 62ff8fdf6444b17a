#include "body.hpp"

#include <cmath>
#include <optional>

#include "body_kernel.hpp"
#include "hawser/physics/module_registry.hpp"
#include "hawser/physics/vector_parameters.hpp"

namespace hawser {
namespace {

double size(const std::vector<double>& vector) {
  double squared = 0;
  for (const double component : vector)
    squared += component * component;
  return std::sqrt(squared);
}

struct LiftDeck {
  Located<std::vector<double>> direction;
  double area = 0;

  static Spec<LiftDeck> spec() {
    using P = LiftDeck;
    return Spec<P>("lift", "A wing of constant lift coefficient.")
        .attribute("direction", &P::direction, "1", required() && any() && length(2, 3),
                   "Where it pulls: of it the part across the flow.")
        .attribute("area", &P::area, "m^2", required() && positive(),
                   "Lift coefficient times area.")
        .check([](const P& p, const Location&, Diagnostics& diagnostics) {
          if (size(p.direction) == 0)
            diagnostics.error(p.direction.location, "a lift needs a direction, not all zeros");
        });
  }
};

struct Body {
  Domain on;
  double mass = 0, added_mass = 0;
  Located<std::vector<double>> gravity;
  std::optional<double> submerged_weight;
  Located<Expressions> current;
  double density = 1025;
  std::optional<double> drag_area;
  std::vector<LiftDeck> lifts;

  static Spec<Body> spec() {
    using P = Body;
    return Spec<P>("body",
                   "A body at a point of a line, such as a towfish, a bird, a depressor or a "
                   "drogue: inertia, weight in water, drag and lift of a given current.")
        .source("packages/modules/body/theory.md")
        .attribute("on", &P::on, required(), "Point regions; one such body at each of them.")
        .attribute("mass", &P::mass, "kg", required() && non_negative(), "Its inertia.")
        .attribute("added-mass", &P::added_mass, "kg", non_negative(),
                   "Of the water that goes along, the same in all directions.")
        .attribute("gravity", &P::gravity, "m/s^2", any() && absent("none"),
                   "Acceleration per direction; the weight is this times mass, unless "
                   "submerged-weight is given.")
        .attribute("submerged-weight", &P::submerged_weight, "N",
                   any() && absent("by gravity and mass"),
                   "Weight in water, along gravity; negative for a body that floats up.")
        .attribute("current", &P::current, "m/s", any() && absent("still water"),
                   "A number or expression per direction, of x y z (moved), X Y Z (reference), t.")
        .attribute("density", &P::density, "kg/m^3", positive(), "Of the water.")
        .attribute("drag-area", &P::drag_area, "m^2", non_negative() && absent("none"),
                   "Drag coefficient times area, of rho CdA |u| u / 2.")
        .children(&P::lifts)
        .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
          if (p.submerged_weight && size(p.gravity) == 0)
            diagnostics.error(where, "submerged-weight needs gravity, which says where down is");
          if (!p.current.value.empty() && !p.drag_area && p.lifts.empty())
            diagnostics.error(p.current.location,
                              "a current does nothing to a body without drag-area and <lift>");
        });
  }
};

template <int D>
PhysicsModule make_body(const Body& deck) {
  BodyProperties<D> body;
  body.mass = deck.mass;
  body.added_mass = deck.added_mass;
  body.density = deck.density;
  body.drag_area = deck.drag_area.value_or(0);
  body.current = deck.current.value;
  body.weight = weight_in_water<D>(deck.gravity, deck.submerged_weight, deck.mass);
  for (const LiftDeck& lift : deck.lifts) {
    Lift<D> made;
    made.area = lift.area;
    for (int i = 0; i < D; ++i)
      made.direction[i] = lift.direction.value[static_cast<std::size_t>(i)] / size(lift.direction);
    body.lifts.push_back(made);
  }
  PhysicsModule module{"body", "structure", {}, {}};
  module.kernels.push_back(std::make_unique<BodyKernel<D>>(deck.on, std::move(body)));
  return module;
}

PhysicsModule make_body_in(const Body& deck, const ModuleContext& context,
                           Diagnostics& diagnostics) {
  const auto check_length = [&](const auto& vector, const std::string& name) {
    check_components(vector, name, context.dimension, diagnostics);
  };
  check_length(deck.gravity, "gravity");
  check_length(deck.current, "current");
  for (const LiftDeck& lift : deck.lifts)
    check_length(lift.direction, "direction");
  if (!diagnostics.ok()) return {};
  return context.dimension == 3 ? make_body<3>(deck) : make_body<2>(deck);
}

}  // namespace

void register_body(ModuleRegistry& registry) { registry.add<Body>(make_body_in); }

}  // namespace hawser
