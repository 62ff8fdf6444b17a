#include "cable.hpp"

#include "cable_kernels.hpp"
#include "hawser/physics/module_registry.hpp"

namespace hawser {
namespace {

struct Cable : CableProperties {
  std::string region;

  static Spec<Cable> spec() {
    using P = Cable;
    return Spec<P>("cable",
                   "Total Lagrangian cable with axial and bending stiffness that carries no "
                   "compression; "
                   "all quantities per metre of depth in two dimensions.")
        .attribute("region", &P::region, required(), "Line region of the cable.")
        .attribute("mass-per-length", &P::mass, "kg/m", positive(), "Inertia per length.")
        .attribute("axial-stiffness", &P::axial_stiffness, "N", positive(), "EA.")
        .attribute("bending-stiffness", &P::bending_stiffness, "N m^2", non_negative(),
                   "EI; with 0 the tail of a towed cable flaps under any refinement.")
        .attribute("damping", &P::damping, "N s/m^2", non_negative(),
                   "External damping force per length and velocity.")
        .attribute("slack-width", &P::slack_width, "1", positive(),
                   "Strain over which the tension is switched off smoothly in compression.")
        .attribute("compressive-ratio", &P::compressive_ratio, "1", between(0, 1),
                   "Stiffness kept in compression, relative to EA.");
  }
};

PhysicsModule make_cable(const Cable& deck) {
  PhysicsModule module{"cable", "structure", {}, {}};
  module.kernels.push_back(std::make_unique<CableKernel>(deck.region, deck));
  if (deck.bending_stiffness > 0)
    module.kernels.push_back(std::make_unique<BendingKernel>(deck.region + "/patches", deck));
  return module;
}

}  // namespace

void register_cable(ModuleRegistry& registry) { registry.add<Cable>(make_cable); }

}  // namespace hawser
