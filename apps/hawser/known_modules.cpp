#include "known_modules.hpp"

#include <filesystem>

#include "ale_fluid.hpp"
#include "cable.hpp"
#include "mesh_motion.hpp"

namespace hawser::program {

ModuleRegistry built_in_modules() {
  ModuleRegistry registry;
  register_ale_fluid(registry);
  register_cable(registry);
  register_mesh_motion(registry);
  return registry;
}

std::string default_plugin_folder() {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  return (program.parent_path().parent_path() / "lib/hawser/plugins").string();
}

}  // namespace hawser::program
