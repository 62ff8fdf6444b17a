#pragma once
// Module <cable>: a slender cable that shares its nodes with the fluid. See theory.md.

namespace hawser {
class ModuleRegistry;
void register_cable(ModuleRegistry& registry);
}  // namespace hawser
