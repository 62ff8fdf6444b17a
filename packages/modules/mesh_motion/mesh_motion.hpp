#pragma once
// Module <mesh-motion>: moves the fluid's mesh as an elastic body. See theory.md.

namespace hawser {
class ModuleRegistry;
void register_mesh_motion(ModuleRegistry& registry);
}  // namespace hawser
