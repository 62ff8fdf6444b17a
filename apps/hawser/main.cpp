// The program: one verb per thing a user does.
#include <CLI/CLI.hpp>
#include <Tpetra_Core.hpp>
#include <mpi.h>

#include <cstdio>
#include <filesystem>

#include "ale_fluid.hpp"
#include "cable.hpp"
#include "hawser/base/error.hpp"
#include "hawser/simulation/deck_parameters.hpp"
#include "hawser/simulation/simulation.hpp"
#include "mesh_motion.hpp"

namespace {

using namespace hawser;

ModuleRegistry built_in_modules() {
  ModuleRegistry registry;
  register_ale_fluid(registry);
  register_cable(registry);
  register_mesh_motion(registry);
  return registry;
}

/// Plug-ins lie beside the libraries: build/lib/hawser/plugins, or lib/hawser/plugins when
/// installed.
std::string default_plugin_folder() {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  return (program.parent_path().parent_path() / "lib/hawser/plugins").string();
}

int exit_code(const Summary& summary) {
  return static_cast<int>(summary.number("expectations_failed").value_or(0) > 0
                              ? ExitCode::expectation
                              : ExitCode::done);
}

struct Arguments {
  std::string file;
  RunOptions run;
  double end = 0;
  bool has_end = false;
};

int perform(const std::string& verb, const Arguments& arguments, const Communicator& world) {
  RunOptions options = arguments.run;
  if (arguments.has_end) options.end = arguments.end;
  if (verb == "run")
    return exit_code(Simulation(world, built_in_modules(), arguments.file, options).run());
  if (verb == "restart")
    return exit_code(Simulation::restart(world, built_in_modules(), arguments.file, options).run());
  if (verb == "check") {
    const Simulation simulation(world, built_in_modules(), arguments.file, options);
    if (world.is_root())
      std::printf("%s: no faults (names of regions and fields are checked when it runs)\n",
                  arguments.file.c_str());
  }
  const ModuleRegistry registry = built_in_modules();
  if (verb == "modules" && world.is_root())
    for (const std::string& tag : registry.tags())
      std::printf("%-14s %s\n", tag.c_str(), registry.find(tag)->spec.meaning.c_str());
  if (verb == "describe") {
    const ModuleRegistry::Entry* const module = registry.find(arguments.file);
    if (module == nullptr && !arguments.file.empty())
      throw Error(ExitCode::usage, "there is no module '" + arguments.file + "'; there are " +
                                       listed(registry.tags()) +
                                       did_you_mean(arguments.file, registry.tags()));
    const std::string text = describe(module ? module->spec : RunDeck::spec().node_spec());
    if (world.is_root()) std::fputs(text.c_str(), stdout);
  }
  return 0;
}

/// Parses, performs, and turns errors into one sentence and an exit code.
int guarded_main(int argc, char** argv, const Communicator& world) {
  CLI::App app{
      "Hawser: towed cables in a current, and what else its parts can be put together to do."};
  app.set_version_flag("--version", HAWSER_VERSION);
  app.require_subcommand(1);
  Arguments arguments;
  arguments.run.plugin_folder = default_plugin_folder();
  const auto common = [&](CLI::App* verb) {
    verb->add_option("--plugin-dir", arguments.run.plugin_folder,
                     "folder that plug-ins are loaded from");
    return verb;
  };
  const auto running = [&](CLI::App* verb, bool needs_output) {
    auto* output = verb->add_option("-o,--output", arguments.run.output, "folder for the results");
    if (needs_output) output->required();
    verb->add_flag("-f,--force", arguments.run.force, "write over the results of a finished run");
    verb->add_flag("-q,--quiet", arguments.run.quiet, "no progress lines");
    verb->add_option("--end", arguments.end, "end time in s, instead of the deck's")
        ->check(CLI::PositiveNumber)
        ->each([&](const std::string&) { arguments.has_end = true; });
  };
  auto* run = common(
      app.add_subcommand("run", "run a deck: hawser run inputs/deep_tow/case_02.xml -o results/a"));
  run->add_option("deck", arguments.file, "XML deck")->required();
  running(run, true);
  auto* restart =
      common(app.add_subcommand("restart", "go on from a checkpoint, on any number of ranks"));
  restart->add_option("checkpoint", arguments.file, "checkpoint.h5 of an earlier run")->required();
  running(restart, false);
  common(app.add_subcommand("check", "read a deck and report every fault in it"))
      ->add_option("deck", arguments.file, "XML deck")
      ->required();
  app.add_subcommand("modules", "list the physics modules");
  app.add_subcommand("describe", "describe a module's parameters, or the whole deck")
      ->add_option("module", arguments.file, "tag of a module");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (!world.is_root()) return error.get_exit_code() == 0 ? 0 : static_cast<int>(ExitCode::usage);
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
  }
  try {
    return perform(app.get_subcommands().front()->get_name(), arguments, world);
  } catch (const Error& error) {
    if (world.is_root()) std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(error.code());
  }
}

}  // namespace

int main(int argc, char** argv) {
  // Not our arguments: Kokkos would answer --help with its own.
  int no_arguments = 1;
  Tpetra::ScopeGuard tpetra(&no_arguments, &argv);
  try {
    return guarded_main(argc, argv, Communicator(MPI_COMM_WORLD));
  } catch (const std::exception& error) {
    // Not an Error, hence perhaps on this rank only: the others would wait for ever.
    std::fprintf(stderr, "internal error, please report it: %s\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  return 1;
}
