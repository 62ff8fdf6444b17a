#include "hawser/simulation/registries.hpp"

#include "ale_fluid.hpp"
#include "body.hpp"
#include "buoyancy.hpp"
#include "cable.hpp"
#include "eddy_viscosity.hpp"
#include "hawser/physics/plugin_loader.hpp"
#include "mesh_motion.hpp"
#include "porous_zone.hpp"
#include "property.hpp"
#include "sea_bed.hpp"
#include "solid.hpp"
#include "tow.hpp"
#include "transport.hpp"

namespace hawser {

Registries built_in() {
  Registries known;
  register_ale_fluid(known.modules);
  register_body(known.modules);
  register_buoyancy(known.modules);
  register_cable(known.modules);
  register_eddy_viscosity(known.modules);
  register_mesh_motion(known.modules);
  register_porous_zone(known.modules);
  register_property(known.modules);
  register_sea_bed(known.modules);
  register_solid(known.modules);
  register_transport(known.modules);
  register_tow(known.reports);
  register_reports(known.reports);
  return known;
}

void load_plugin(const std::string& name, const std::string& folder, Registries& registries) {
  load_plugin(name, folder,
              {module_export(registries.modules),
               plugin_export("hawser_report_plugin", registries.reports)});
}

}  // namespace hawser
