#include "porous_zone.hpp"

#include <cmath>

#include "hawser/physics/module_registry.hpp"
#include "hawser/physics/point_property.hpp"

namespace hawser {
namespace {

struct PorousZone {
  Domain region;
  double linear = 0;
  double quadratic = 0;

  static Spec<PorousZone> spec() {
    using P = PorousZone;
    return Spec<P>("porous-zone",
                   "Darcy's and Forchheimer's resistance -(a + b |v|) v, a force per mass of the "
                   "fluid: nets, screens, vegetation, gravel.")
        .source("packages/modules/porous_zone/theory.md")
        .attribute("region", &P::region, required(), "Regions of the fluid that are porous.")
        .attribute("linear", &P::linear, "1/s", non_negative(),
                   "Coefficient a: kinematic viscosity over permeability.")
        .attribute("quadratic", &P::quadratic, "1/m", non_negative(),
                   "Coefficient b: half the pressure loss coefficient per metre.");
  }
};

template <int D>
class PorousResistance : public PointProperty<PorousResistance<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr PropertyUse supplies = property::body_force<D>;
  static constexpr std::array<FieldUse, 1> uses = {
      StandardFields<D>::velocity.as(Role::reads, need::value)};
  static constexpr Slot<0> velocity{};

  explicit PorousResistance(const PorousZone& zone)
      : linear_(zone.linear), quadratic_(zone.quadratic) {}

  template <class Point>
  auto law(const Point& at) const {
    using T = typename Point::Number;
    using std::sqrt;
    constexpr double smoothing = 1e-20;  // m^2/s^2: |v| has a derivative at rest, too
    const auto& v = at[velocity].value;
    const T speed = sqrt(dot(v, v) + smoothing);
    Vector<T, D> force;
    for (int i = 0; i < D; ++i)
      force[i] = -(linear_ + quadratic_ * speed) * v[i];
    return force;
  }

 private:
  double linear_, quadratic_;
};

PhysicsModule make_porous_zone(const PorousZone& deck) {
  PhysicsModule module{"porous-zone", "", {}, {}};
  module.supplies.push_back({deck.region, true, std::make_unique<PorousResistance<2>>(deck)});
  return module;
}

}  // namespace

void register_porous_zone(ModuleRegistry& registry) { registry.add<PorousZone>(make_porous_zone); }

}  // namespace hawser
