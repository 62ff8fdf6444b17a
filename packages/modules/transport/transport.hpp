#pragma once
// See theory.md.

namespace hawser {
class ModuleRegistry;
void register_transport(ModuleRegistry& registry);  ///< <heat> and <scalar-transport>
}  // namespace hawser
