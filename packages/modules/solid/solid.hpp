#pragma once
// Module <solid>: an elastic body under large deformations. See theory.md.

namespace hawser {
class ModuleRegistry;
void register_solid(ModuleRegistry& registry);
}  // namespace hawser
