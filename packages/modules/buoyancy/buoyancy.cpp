#include "buoyancy.hpp"

#include "hawser/physics/module_registry.hpp"
#include "hawser/physics/point_property.hpp"

namespace hawser {
namespace {

struct Buoyancy {
  Domain region;
  double expansion = 0;
  double reference = 0;
  std::vector<double> gravity = {0, -9.81};

  static Spec<Buoyancy> spec() {
    using P = Buoyancy;
    return Spec<P>("buoyancy",
                   "Boussinesq's body force -beta (T - T0) g: what the temperature changes of the "
                   "weight; that of the reference state is in the pressure.")
        .source("packages/modules/buoyancy/theory.md")
        .attribute("region", &P::region, required(), "Regions of the fluid.")
        .attribute("expansion", &P::expansion, "1/K", required() && any(),
                   "Volumetric thermal expansion beta.")
        .attribute("reference", &P::reference, "K", required() && any(),
                   "Temperature T0 at which there is no force, on the scale of the field.")
        .attribute("gravity", &P::gravity, "m/s^2", any() && length(2),
                   "Acceleration g by gravity.");
  }
};

template <int D>
class BoussinesqForce : public PointProperty<BoussinesqForce<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr PropertyUse supplies = property::body_force<D>;
  static constexpr std::array<FieldUse, 1> uses = {
      StandardFields<D>::temperature.as(Role::reads, need::value)};
  static constexpr Slot<0> temperature{};

  explicit BoussinesqForce(Buoyancy deck) : deck_(std::move(deck)) {}

  template <class Point>
  auto law(const Point& at) const {
    Vector<typename Point::Number, D> force;
    for (int i = 0; i < D; ++i)
      force[i] = -deck_.expansion * deck_.gravity[static_cast<std::size_t>(i)] *
                 (at[temperature].value - deck_.reference);
    return force;
  }

 private:
  Buoyancy deck_;
};

PhysicsModule make_buoyancy(const Buoyancy& deck) {
  PhysicsModule module{"buoyancy", "", {}, {}};
  module.supplies.push_back({deck.region, true, std::make_unique<BoussinesqForce<2>>(deck)});
  return module;
}

}  // namespace

void register_buoyancy(ModuleRegistry& registry) { registry.add<Buoyancy>(make_buoyancy); }

}  // namespace hawser
