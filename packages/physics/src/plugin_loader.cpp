#include "hawser/physics/plugin_loader.hpp"

#include <dlfcn.h>
#include <sys/stat.h>

#include <filesystem>

#include "hawser/base/error.hpp"
#include "hawser/physics/abi.hpp"

namespace hawser {
namespace {

/// What one may write everybody may write: it would run whatever others put there.
bool everybody_may_write(const std::string& path) {
  struct stat status = {};
  return stat(path.c_str(), &status) == 0 && (status.st_mode & S_IWOTH) != 0;
}

/// The library's file; nothing of it is loaded yet.
std::string find_plugin(const std::string& name, const std::string& folder) {
  const std::string plugin = "plug-in '" + name + "'";
  if (name.empty() || name.find('/') != std::string::npos || name.find("..") != std::string::npos)
    throw PluginError(plugin + ": give the bare name; plug-ins are loaded from " + folder +
                      " only");
  if (folder.empty())
    throw PluginError(plugin + ": --plugin-dir is empty; give a folder, . for this one");
  std::string path = folder + "/" + name + ".so";
  std::error_code none;
  if (!std::filesystem::exists(path, none))
    throw PluginError(plugin + " not found: there is no " + path);
  for (const std::string& place : {folder, path})
    if (everybody_may_write(place))
      throw PluginError(plugin + " is not loaded: everybody may write " + place +
                        "; chmod o-w makes it safe");
  return path;
}

using Stamp = const char* (*)();

void require_fitting(const std::string& plugin, Stamp stamp) {
  if (std::string(stamp()) != HAWSER_ABI_STAMP)
    throw PluginError(plugin + " was built for " + stamp() + ", this program is " +
                      HAWSER_ABI_STAMP + "; build it again");
}

Stamp stamp_of(void* library, const PluginExport& kind) {
  return reinterpret_cast<Stamp>(dlsym(library, (kind.prefix + "_stamp").c_str()));
}

/// Symbols stay local: two plug-ins may use the same names. Never closed: modules live in it.
void* open_library(const std::string& plugin, const std::string& path,
                   const std::vector<PluginExport>& exports) {
  if (void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) return library;
  const std::string why = dlerror();
  // One of another build may lack symbols here; its stamp, which needs none, says so more clearly.
  if (void* const library = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL))
    for (const PluginExport& kind : exports)
      if (const Stamp stamp = stamp_of(library, kind)) require_fitting(plugin, stamp);
  throw PluginError(plugin + " cannot be loaded: " + why);
}

void call(const std::string& plugin, const PluginExport& kind, void* symbol) {
  const std::string failed = plugin + " failed while it registered its parts: ";
  try {
    kind.call(symbol);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw PluginError(failed + error.what());
  } catch (...) {
    throw PluginError(failed + "it threw something that is no std::exception");
  }
}

}  // namespace

void load_plugin(const std::string& name, const std::string& folder,
                 const std::vector<PluginExport>& exports) {
  const std::string plugin = "plug-in '" + name + "'";
  const std::string path = find_plugin(name, folder);
  void* const library = open_library(plugin, path, exports);
  bool empty = true;
  for (const PluginExport& kind : exports) {
    const Stamp stamp = stamp_of(library, kind);
    void* const symbol = dlsym(library, (kind.prefix + "_register").c_str());
    if (stamp == nullptr || symbol == nullptr) continue;
    require_fitting(plugin, stamp);
    call(plugin, kind, symbol);
    empty = false;
  }
  if (empty)
    throw PluginError(plugin + " (" + path +
                      ") exports no HAWSER_PLUGIN(registry) {...}: it is not a Hawser plug-in");
}

}  // namespace hawser
