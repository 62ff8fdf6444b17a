#pragma once
// See theory.md.

namespace hawser {
class ModuleRegistry;
void register_sea_bed(ModuleRegistry& registry);
}  // namespace hawser
