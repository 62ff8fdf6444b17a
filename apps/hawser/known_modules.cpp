#include "known_modules.hpp"

#include <filesystem>

#include "ale_fluid.hpp"
#include "cable.hpp"
#include "mesh_motion.hpp"
#include "tow.hpp"

namespace hawser::program {

Registries built_in() {
  Registries known;
  register_ale_fluid(known.modules);
  register_cable(known.modules);
  register_mesh_motion(known.modules);
  register_tow(known.reports);
  register_reports(known.reports);
  return known;
}

std::string default_plugin_folder() {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  return (program.parent_path().parent_path() / "lib/hawser/plugins").string();
}

}  // namespace hawser::program
