#include "hawser/simulation/environment.hpp"

#include <cstdio>

#include "hawser/algebra/parallel_runtime.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/installation.hpp"
#include "src/plugins.hpp"

namespace hawser {
Environment::Environment() : Environment(MPI_COMM_WORLD) {}

Environment::Environment(MPI_Comm adopted)
    : registries(built_in()),
      plugin_folder(plugins_beside()),
      runtime_(adopted == MPI_COMM_NULL ? nullptr : std::make_unique<ParallelRuntime>()),
      communicator_(adopted) {}

Environment::~Environment() = default;

std::string Environment::plugins_beside() {
  return (installation_folder() / "lib/hawser/plugins").string();
}

void Environment::load_plugin(const std::string& name) {
  const std::vector<PluginDeck> plugins = {{{name, {}}}};
  rehearse_plugins(communicator_, plugin_folder, plugins, registries);
  load_plugins(communicator_, plugin_folder, plugins, registries);
}

int Environment::guarded(const std::function<int()>& work) const {
  try {
    return work();
  } catch (const Error& error) {
    if (communicator_.is_root()) std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "internal error, please report it: %s\n", error.what());
    if (communicator_.mpi() != MPI_COMM_NULL) MPI_Abort(communicator_.mpi(), 1);
    return 1;
  }
}

}  // namespace hawser
