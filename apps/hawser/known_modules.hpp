#pragma once
#include <string>

#include "hawser/simulation/registries.hpp"

namespace hawser::program {

Registries built_in();

/// Plug-ins lie beside the libraries: build/lib/hawser/plugins, or lib/hawser/plugins when
/// installed.
std::string default_plugin_folder();

}  // namespace hawser::program
