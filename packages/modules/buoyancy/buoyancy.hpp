#pragma once
// See theory.md.

namespace hawser {
class ModuleRegistry;
void register_buoyancy(ModuleRegistry& registry);
}  // namespace hawser
