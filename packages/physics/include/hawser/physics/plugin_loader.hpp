#pragma once
#include <string>
#include <vector>

#include "hawser/physics/module_registry.hpp"

namespace hawser {

/// Loads shared libraries by name from `folder` and lets each fill the registry. They stay loaded.
/// PluginError: a name that leaves the folder, no such file, not a library, a foreign stamp.
void load_plugin(const std::string& name, const std::string& folder, ModuleRegistry& registry);

}  // namespace hawser
