#include "mesh_motion.hpp"

#include "hawser/physics/formula_property.hpp"
#include "hawser/physics/module_registry.hpp"
#include "mesh_motion_kernel.hpp"

namespace hawser {
namespace {

struct MeshMotion : MeshStiffness {
  Domain region;
  FieldExpressions body_force, stiffness;

  static Spec<MeshMotion> spec() {
    using P = MeshMotion;
    return Spec<P>("mesh-motion",
                   "Moves the mesh as a linear elastic body, stiffer where cells are small.")
        .source("packages/modules/mesh_motion/theory.md")
        .attribute("region", &P::region, required(), "Regions whose mesh moves.")
        .choice(
            "reference", &P::incremental, {{"incremental", true}, {"total", false}},
            "Elastic about the last accepted configuration (long tows) or about the initial one "
            "(periodic motion: the mesh returns where it was).")
        .attribute("stiffening-power", &P::power, "1", non_negative(),
                   "Young's modulus goes with the cell's area to minus this power.")
        .attribute("poisson-ratio", &P::poisson, "1", between(0, 0.49),
                   "Poisson's ratio of the mesh.")
        .attribute("stiffness", &P::stiffness, "1",
                   positive() && length(1) && absent("what other modules supply, or 1"),
                   "Factor of Young's modulus: a number or an expression of x y z (moved), X Y Z "
                   "(reference), t, fields and their derivatives.")
        .attribute("body-force", &P::body_force, "1/m", any() && length(2) && absent("none"),
                   "Force per volume over the local Young's modulus, for manufactured solutions: "
                   "two expressions of x y z (moved), X Y Z (reference), t.");
  }
};

PhysicsModule make_mesh_motion(const MeshMotion& deck) {
  PhysicsModule module{"mesh-motion", "mesh", {}, {}};
  auto constants =
      give({{property::mesh_stiffness, deck.stiffness}, {mesh_load<2>, deck.body_force}},
           deck.region, 2, module.supplies);
  module.kernels.push_back(
      std::make_unique<MeshMotionKernel<2>>(deck.region, deck, std::move(constants)));
  return module;
}

}  // namespace

void register_mesh_motion(ModuleRegistry& registry) { registry.add<MeshMotion>(make_mesh_motion); }

}  // namespace hawser
