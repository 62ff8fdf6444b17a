#pragma once
// See theory.md.

namespace hawser {
class ModuleRegistry;
void register_eddy_viscosity(ModuleRegistry& registry);
}  // namespace hawser
