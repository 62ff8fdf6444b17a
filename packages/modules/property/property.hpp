#pragma once
namespace hawser {
class ModuleRegistry;
void register_property(ModuleRegistry& registry);
}  // namespace hawser
