// Runs, runs that go on, and the check of a deck.
#include <cstdio>

#include "hawser/base/error.hpp"
#include "hawser/simulation/simulation.hpp"
#include "known_modules.hpp"
#include "run_options.hpp"
#include "verb.hpp"

namespace hawser::program {
namespace {

struct Arguments {
  std::string file;
  RunOptions options;
};

int exit_code(const Summary& summary) {
  return static_cast<int>(summary.number("expectations_failed").value_or(0) > 0
                              ? ExitCode::expectation
                              : ExitCode::done);
}

std::shared_ptr<Arguments> new_arguments(CLI::App& verb) {
  auto arguments = std::make_shared<Arguments>();
  arguments->options.plugin_folder = default_plugin_folder();
  verb.add_option("--plugin-dir", arguments->options.plugin_folder,
                  "folder that plug-ins are loaded from");
  return arguments;
}

}  // namespace

void add_changes(CLI::App& verb, RunOptions& options) {
  verb.add_option_function<std::vector<std::string>>(
          "--set",
          [&options](const std::vector<std::string>& changes) {
            try {
              for (const std::string& change : changes)
                options.changes.push_back(read_change(change));
            } catch (const Error& error) {
              throw CLI::ValidationError(error.what());
            }
          },
          "replace a value of the deck: time/step=5, or a parameter: tow_speed=0.3; repeatable")
      ->allow_extra_args(false);
}

namespace {

void add_run_options(CLI::App& verb, RunOptions& options, bool needs_output) {
  verb.add_option("-o,--output", options.output, "folder for the results")->required(needs_output);
  verb.add_flag("-f,--force", options.force, "write over the results of a finished run");
  verb.add_flag("-q,--quiet", options.quiet, "no progress lines");
  verb.add_option("--end", options.end, "end time in s, instead of the deck's")
      ->check(CLI::PositiveNumber);
}

Verb run_verb(CLI::App& app) {
  auto* verb =
      app.add_subcommand("run", "run a deck: hawser run inputs/deep_tow/case_02.xml -o results/a");
  const auto arguments = new_arguments(*verb);
  verb->add_option("deck", arguments->file, "XML deck")->required();
  add_changes(*verb, arguments->options);
  add_run_options(*verb, arguments->options, true);
  return {verb, OnRanks([arguments](const Communicator& world) {
            return exit_code(
                Simulation(world, built_in_modules(), arguments->file, arguments->options).run());
          })};
}

Verb restart_verb(CLI::App& app) {
  auto* verb = app.add_subcommand("restart", "go on from a checkpoint, on any number of ranks");
  const auto arguments = new_arguments(*verb);
  verb->add_option("checkpoint", arguments->file, "checkpoint.h5 of an earlier run")->required();
  add_run_options(*verb, arguments->options, false);
  return {verb, OnRanks([arguments](const Communicator& world) {
            return exit_code(
                Simulation::restart(world, built_in_modules(), arguments->file, arguments->options)
                    .run());
          })};
}

Verb check_verb(CLI::App& app) {
  auto* verb = app.add_subcommand("check", "read a deck and report every fault in it");
  const auto arguments = new_arguments(*verb);
  verb->add_option("deck", arguments->file, "XML deck")->required();
  add_changes(*verb, arguments->options);
  return {verb, OnRanks([arguments](const Communicator& world) {
            const Simulation simulation(world, built_in_modules(), arguments->file,
                                        arguments->options);
            if (world.is_root())
              std::printf("%s: no faults (names of regions and fields are checked when it runs)\n",
                          arguments->file.c_str());
            return 0;
          })};
}

}  // namespace

std::vector<Verb> run_verbs(CLI::App& app) {
  return {run_verb(app), restart_verb(app), check_verb(app)};
}

}  // namespace hawser::program
