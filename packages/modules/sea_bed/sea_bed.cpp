#include "sea_bed.hpp"

#include "hawser/physics/module_registry.hpp"
#include "sea_bed_kernel.hpp"

namespace hawser {
namespace {

struct SeaBed : SeaBedProperties {
  Domain region;
  Expression level;

  static Spec<SeaBed> spec() {
    using P = SeaBed;
    return Spec<P>("sea-bed",
                   "Ground on which lines come to lie: it pushes up, along the last coordinate, "
                   "and rubs.")
        .source("packages/modules/sea_bed/theory.md")
        .attribute("region", &P::region, required(), "Line regions that may touch it.")
        .attribute("level", &P::level, "m", required() && any(),
                   "Its last coordinate, a number or an expression of the other ones (x y, moved); "
                   "the slope is meant to be gentle.")
        .attribute("stiffness", &P::stiffness, "N/m^2", positive(),
                   "Reaction per length of line and depth in the ground; a line sinks in by its "
                   "weight per length over this.")
        .attribute("onset", &P::onset, "m", positive(),
                   "Height above the ground, and depth in it, between which the reaction sets in.")
        .attribute("friction", &P::friction, "1", non_negative(),
                   "Coulomb's coefficient, against the line's velocity over the ground.")
        .attribute("creep-speed", &P::creep_speed, "m/s", positive(),
                   "Speed over which friction sets in; a line that is held by it creeps at less.");
  }
};

PhysicsModule make_sea_bed(const SeaBed& deck, const ModuleContext& context,
                           Diagnostics& /*diagnostics*/) {
  PhysicsModule module{"sea-bed", "structure", {}, {}};
  if (context.dimension == 3)
    module.kernels.push_back(std::make_unique<SeaBedKernel<3>>(deck.region, deck, deck.level));
  else
    module.kernels.push_back(std::make_unique<SeaBedKernel<2>>(deck.region, deck, deck.level));
  return module;
}

}  // namespace

void register_sea_bed(ModuleRegistry& registry) { registry.add<SeaBed>(make_sea_bed); }

}  // namespace hawser
