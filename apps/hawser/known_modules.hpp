#pragma once
#include <string>

#include "hawser/physics/module_registry.hpp"

namespace hawser::program {

ModuleRegistry built_in_modules();

/// Plug-ins lie beside the libraries: build/lib/hawser/plugins, or lib/hawser/plugins when
/// installed.
std::string default_plugin_folder();

}  // namespace hawser::program
