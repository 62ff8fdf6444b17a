#include "eddy_viscosity.hpp"

#include <cmath>

#include "hawser/physics/module_registry.hpp"
#include "hawser/physics/place_function.hpp"
#include "hawser/physics/point_property.hpp"

namespace hawser {
namespace {

enum class Model { smagorinsky, mixing_length };

struct EddyViscosity {
  Domain region;
  Model model = Model::smagorinsky;
  double constant = 0.17;
  Expression length{};

  static Spec<EddyViscosity> spec() {
    using P = EddyViscosity;
    return Spec<P>("eddy-viscosity",
                   "Turbulence by an algebraic model: a kinematic viscosity l^2 |S| beside the "
                   "molecular one, with |S| = (2 S:S)^1/2 of the strain rate S.")
        .source("packages/modules/eddy_viscosity/theory.md")
        .attribute("region", &P::region, required(), "Regions of the fluid.")
        .choice("model", &P::model, required(),
                {{"smagorinsky", Model::smagorinsky}, {"mixing-length", Model::mixing_length}},
                "The length l: \"smagorinsky\" is constant times the size of the cell, "
                "\"mixing-length\" is given.")
        .attribute("constant", &P::constant, "1", positive(), "Smagorinsky's constant.")
        .attribute("length", &P::length, "m", non_negative(),
                   "Mixing length: a number or an expression of x y z (moved), X Y Z (reference), "
                   "t, such as 0.41*min(y, 0.09).");
  }
};

template <int D>
class EddyViscosityLaw : public MovingPointProperty<EddyViscosityLaw<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr PropertyUse supplies = property::eddy_viscosity;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<D>::velocity.as(Role::reads, need::gradient),
      StandardFields<D>::displacement.as(Role::reads_if_solved, need::value | need::gradient)};
  static constexpr Slot<0> velocity{};
  static constexpr Slot<1> displacement{};

  explicit EddyViscosityLaw(EddyViscosity deck) : deck_(std::move(deck)) {}

  template <class Point>
  auto moved_law(const Point& at) const {
    using T = typename Point::Number;
    using std::sqrt;
    constexpr double smoothing = 1e-20;  // 1/s^2: |S| has a derivative at rest, too
    const auto& gradient = at[velocity].gradient;
    T twice_strain_squared = smoothing;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        twice_strain_squared += gradient(i, j) * (gradient(i, j) + gradient(j, i));
    const T l = length(at);
    return T(l * l * sqrt(twice_strain_squared));
  }

 private:
  template <class Point>
  typename Point::Number length(const Point& at) const {
    using T = typename Point::Number;
    if (deck_.model == Model::mixing_length)
      return at_place(deck_.length, at.position, at[displacement].value, at.time);
    using std::pow;
    // Edge of a square or cube, or twice the legs of half a one.
    const double reference_size = at.reference.shape->simplex ? (D == 2 ? 2.0 : 6.0) : 1.0;
    const T volume = reference_size * at.reference.shape->measure * at.frame.volume /
                     determinant(at.reference.inverse_jacobian);
    return T(deck_.constant * pow(volume, 1.0 / D));
  }

  EddyViscosity deck_;
};

PhysicsModule make_eddy_viscosity(const EddyViscosity& deck) {
  PhysicsModule module{"eddy-viscosity", "", {}, {}};
  module.supplies.push_back({deck.region, true, std::make_unique<EddyViscosityLaw<2>>(deck)});
  return module;
}

}  // namespace

void register_eddy_viscosity(ModuleRegistry& registry) {
  registry.add<EddyViscosity>(make_eddy_viscosity);
}

}  // namespace hawser
