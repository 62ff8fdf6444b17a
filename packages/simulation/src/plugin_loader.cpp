#include "hawser/simulation/plugin_loader.hpp"

#include <dlfcn.h>

#include <filesystem>

#include "hawser/base/error.hpp"
#include "hawser/physics/abi.hpp"

namespace hawser {

void load_plugin(const std::string& name, const std::string& folder, ModuleRegistry& registry) {
  if (name.find('/') != std::string::npos || name.find("..") != std::string::npos)
    throw PluginError("plug-in '" + name + "': give the bare name; plug-ins are loaded from " +
                      folder + " only");
  const std::string path = folder + "/" + name + ".so";
  if (!std::filesystem::exists(path))
    throw PluginError("plug-in '" + name + "' not found: there is no " + path);
  // Symbols stay local: two plug-ins may use the same names. Never closed: modules live in it.
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw PluginError("plug-in '" + name + "' cannot be loaded: " + dlerror());
  using Stamp = const char* (*)();
  using Register = void (*)(ModuleRegistry&);
  const auto stamp = reinterpret_cast<Stamp>(dlsym(library, "hawser_plugin_stamp"));
  const auto fill = reinterpret_cast<Register>(dlsym(library, "hawser_plugin_register"));
  if (stamp == nullptr || fill == nullptr)
    throw PluginError("plug-in '" + name + "' (" + path +
                      ") exports no HAWSER_PLUGIN(registry) {...}: it is not a Hawser plug-in");
  if (std::string(stamp()) != HAWSER_ABI_STAMP)
    throw PluginError("plug-in '" + name + "' was built for " + stamp() + ", this program is " +
                      HAWSER_ABI_STAMP + "; build it again");
  try {
    fill(registry);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw PluginError("plug-in '" + name +
                      "' failed while it registered its modules: " + error.what());
  }
}

}  // namespace hawser
