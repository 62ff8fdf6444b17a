#pragma once
// Stable: part of the interface for programs that embed Hawser (doc/embedding.md).
#include <string>

#include "hawser/physics/module_registry.hpp"
#include "hawser/report/report_registry.hpp"

namespace hawser {

/// What decks may name: filled by the program, and by plug-ins in the same way.
struct Registries {
  ModuleRegistry modules;
  ReportRegistry reports;
};

/// What comes with Hawser.
Registries built_in();

/// Fills the registries from a shared library. PluginError (physics/plugin_loader.hpp).
void load_plugin(const std::string& name, const std::string& folder, Registries& registries);

}  // namespace hawser
