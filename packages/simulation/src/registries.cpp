#include "hawser/simulation/registries.hpp"

#include "hawser/physics/plugin_loader.hpp"

namespace hawser {

void load_plugin(const std::string& name, const std::string& folder, Registries& registries) {
  load_plugin(name, folder,
              {module_export(registries.modules),
               plugin_export("hawser_report_plugin", registries.reports)});
}

}  // namespace hawser
