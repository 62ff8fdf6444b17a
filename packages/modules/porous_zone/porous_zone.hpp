#pragma once
// See theory.md.

namespace hawser {
class ModuleRegistry;
void register_porous_zone(ModuleRegistry& registry);
}  // namespace hawser
