#pragma once
#include <functional>
#include <string>
#include <vector>

#include "hawser/physics/module_registry.hpp"

namespace hawser {

/// One kind of what a plug-in may export: the functions PREFIX_stamp and PREFIX_register.
struct PluginExport {
  std::string prefix;
  std::function<void(void* symbol)> call;  ///< calls the function PREFIX_register
};

template <class Registry>
PluginExport plugin_export(const std::string& prefix, Registry& registry) {
  return {prefix,
          [&registry](void* symbol) { reinterpret_cast<void (*)(Registry&)>(symbol)(registry); }};
}

/// HAWSER_PLUGIN(registry) {...}.
inline PluginExport module_export(ModuleRegistry& registry) {
  return plugin_export("hawser_plugin", registry);
}

/// Loads a shared library by name from `folder` and lets it fill the registries of all that it
/// exports. It stays loaded. PluginError: a name that leaves the folder, no such file, not a
/// library, nothing exported, a foreign stamp.
void load_plugin(const std::string& name, const std::string& folder,
                 const std::vector<PluginExport>& exports);

}  // namespace hawser
