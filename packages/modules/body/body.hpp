#pragma once
// See theory.md.

namespace hawser {
class ModuleRegistry;
void register_body(ModuleRegistry& registry);
}  // namespace hawser
