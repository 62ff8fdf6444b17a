// Runs, runs that go on, the check of a deck, and its mesh.
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "hawser/base/duration.hpp"
#include "hawser/base/error.hpp"
#include "hawser/simulation/run.hpp"
#include "run_options.hpp"
#include "verb.hpp"

namespace hawser::program {
namespace {

struct Arguments {
  std::string file;
  std::string plugin_folder;
  CaseOptions of_case;
  RunOptions options;
  bool quiet = false, verbose = false, dry_run = false, with_mesh = false;
};

int exit_code(const Summary& summary) {
  return static_cast<int>(summary.number("expectations_failed").value_or(0) > 0
                              ? ExitCode::expectation
                              : ExitCode::done);
}

int print(const Environment& environment, const std::string& text) {
  if (environment.communicator().is_root()) std::fputs(text.c_str(), stdout);
  return 0;
}

std::shared_ptr<Arguments> new_arguments(CLI::App& verb) {
  auto arguments = std::make_shared<Arguments>();
  add_plugin_folder(verb, arguments->plugin_folder);
  return arguments;
}

Case case_of(const Arguments& arguments, Environment& environment) {
  environment.plugin_folder = arguments.plugin_folder;
  return Case::from_file(environment, arguments.file, arguments.of_case);
}

}  // namespace

void add_plugin_folder(CLI::App& verb, std::string& folder) {
  folder = Environment::plugins_beside();
  verb.add_option("--plugin-dir", folder, "folder that plug-ins are loaded from");
}

void add_changes(CLI::App& verb, std::vector<DeckChange>& changes) {
  verb.add_option_function<std::vector<std::string>>(
          "--set",
          [&changes](const std::vector<std::string>& given) {
            try {
              for (const std::string& change : given)
                changes.push_back(read_change(change));
            } catch (const Error& error) {
              throw CLI::ValidationError(error.what());
            }
          },
          "replace a value of the deck: time/step=5, or a parameter: tow_speed=0.3; take one away: "
          "tow/angle=, expect[end_error_m]=; repeatable")
      ->allow_extra_args(false);
}

namespace {

void add_run_options(CLI::App& verb, Arguments& arguments) {
  verb.add_option("-o,--output", arguments.options.output, "folder for the results");
  verb.add_flag("-f,--force", arguments.options.force, "write over the results of another run");
  verb.add_option("--end", arguments.of_case.end, "end time in s, instead of the deck's")
      ->check([](const std::string& given) -> std::string {
        double seconds = 0;
        if (CLI::detail::lexical_cast(given, seconds) && std::isfinite(seconds) && seconds > 0)
          return "";
        return "'" + given +
               "' is no end time; needed is a number of seconds, greater than 0, or "
               "--set time/end=\"1 h\" with a unit";
      });
  verb.add_option_function<std::string>(
      "--stop-after",
      [&arguments](const std::string& given) {
        try {
          arguments.options.stop_after = read_duration(given);
        } catch (const Error& error) {
          throw CLI::ValidationError(error.what());
        }
      },
      "wall time such as 5h50m, 90m or 1d12h after which the run stops as it does by a signal");
  auto* quiet = verb.add_flag("-q,--quiet", arguments.quiet, "tell what goes wrong only");
  auto* verbose =
      verb.add_flag("-v,--verbose", arguments.verbose, "a line per Newton iteration, too");
  auto* json =
      verb.add_flag("--log-json", arguments.options.log_json, "tell in JSON, one object per line");
  quiet->excludes(verbose, json);
  verbose->excludes(json);
}

/// With --log-json an error is the last object; the sentence for people follows as ever.
template <class Work>
int told(const Communicator& world, const Arguments& arguments, const Work& work) {
  try {
    return exit_code(work());
  } catch (const Error& error) {
    if (arguments.options.log_json && world.is_root()) {
      const nlohmann::ordered_json event = {{"event", "error"},
                                            {"message", error.what()},
                                            {"exit_code", static_cast<int>(error.code())}};
      std::printf("%s\n",
                  event.dump(-1, ' ', false, decltype(event)::error_handler_t::replace).c_str());
      std::fflush(stdout);
    }
    throw;
  }
}

RunOptions options_of(const Arguments& arguments) {
  RunOptions options = arguments.options;
  if (arguments.quiet) options.detail = LogDetail::quiet;
  if (arguments.verbose) options.detail = LogDetail::iterations;
  return options;
}

Verb run_verb(CLI::App& app) {
  auto* verb = app.add_subcommand("run", "run a deck");
  verb->footer(
      "Example: mpirun -np 2 hawser run inputs/deep_tow/case_02.xml -o results/case_02\n"
      "SIGTERM, SIGINT, SIGUSR1, SIGHUP, SIGXCPU: checkpoint and stop, exit code 75. SIGUSR2: "
      "checkpoint.");
  const auto arguments = new_arguments(*verb);
  verb->add_option("deck", arguments->file, "XML deck")->required();
  add_changes(*verb, arguments->of_case.changes);
  add_run_options(*verb, *arguments);
  verb->add_flag("--dry-run", arguments->dry_run,
                 "say what it would take: unknowns, memory, mesh, Courant number");
  return {verb, OnRanks([arguments](Environment& environment) {
            const RunOptions options = options_of(*arguments);
            if (arguments->dry_run)
              return print(environment, preview(case_of(*arguments, environment)));
            if (options.output.empty())
              throw Error(ExitCode::usage,
                          "where to? Give a folder for the results: -o FOLDER\n"
                          "Run with --help for more information.");
            return told(environment.communicator(), *arguments,
                        [&] { return run(case_of(*arguments, environment), options); });
          })};
}

Verb restart_verb(CLI::App& app) {
  auto* verb = app.add_subcommand("restart", "go on from a checkpoint, on any number of ranks");
  verb->footer(
      "Example: mpirun -np 3 hawser restart results/case_02/checkpoint.h5\n"
      "--set changes what a run may change on its way: its end, its step, solver, output.");
  const auto arguments = new_arguments(*verb);
  verb->add_option("checkpoint", arguments->file, "checkpoint.h5 of an earlier run")->required();
  add_changes(*verb, arguments->of_case.changes);
  add_run_options(*verb, *arguments);
  return {verb, OnRanks([arguments](Environment& environment) {
            environment.plugin_folder = arguments->plugin_folder;
            return told(environment.communicator(), *arguments, [&] {
              return run(Case::from_checkpoint(environment, arguments->file, arguments->of_case),
                         options_of(*arguments));
            });
          })};
}

Verb check_verb(CLI::App& app) {
  auto* verb = app.add_subcommand(
      "check", "read a deck, or a study with all its cases, and report every fault");
  verb->footer("Example: hawser check --mesh inputs/deep_tow/case_02_quick.xml");
  const auto arguments = new_arguments(*verb);
  verb->add_option("deck", arguments->file, "XML deck or study")->required();
  add_changes(*verb, arguments->of_case.changes);
  verb->add_flag("--mesh", arguments->with_mesh,
                 "make or read the mesh, too, audit it, and check all that a run would; of a line "
                 "alone always");
  return {verb, OnRanks([arguments](Environment& environment) {
            environment.plugin_folder = arguments->plugin_folder;
            if (const auto study = check_study(environment, arguments->file))
              return print(environment, *study);
            const Case run_case = case_of(*arguments, environment);
            if (arguments->with_mesh || run_case.has_line_mesh())
              return print(environment,
                           check_with_mesh(run_case) + arguments->file + ": no faults\n");
            return print(environment,
                         arguments->file +
                             ": no faults (names of regions and fields, the mesh and what fits "
                             "together: --mesh)\n");
          })};
}

Verb jacobian_verb(CLI::App& app) {
  auto* verb = app.add_subcommand(
      "jacobian", "compare the tangent of every kernel of a deck with differences of its residual");
  verb->footer(
      "Example: hawser jacobian --plugin-dir build my.xml\n"
      "Exit code 8 when a block is off by more than 1e-6 of its largest entry.");
  const auto arguments = new_arguments(*verb);
  verb->add_option("deck", arguments->file, "XML deck")->required();
  add_changes(*verb, arguments->of_case.changes);
  return {verb, OnRanks([arguments](Environment& environment) {
            const TangentCheck check = check_tangents(case_of(*arguments, environment));
            print(environment, check.text);
            return static_cast<int>(check.holds ? ExitCode::done : ExitCode::expectation);
          })};
}

/// Never over a file of the user's.
void refuse_existing(const Communicator& world, const std::string& file) {
  world.on_root([&] {
    std::error_code none;
    if (std::filesystem::exists(file, none))
      throw OutputError(file + " is there already; choose another name, or --force to replace it");
  });
}

Verb mesh_verb(CLI::App& app) {
  auto* verb = app.add_subcommand("mesh", "make a deck's mesh alone, and say what it is like");
  verb->footer("Example: hawser mesh inputs/deep_tow/case_02.xml -o case_02.msh");
  const auto arguments = new_arguments(*verb);
  verb->add_option("deck", arguments->file, "XML deck")->required();
  add_changes(*verb, arguments->of_case.changes);
  verb->add_option("-o,--output", arguments->options.output, "file for the mesh, MSH 4.1");
  verb->add_flag("-f,--force", arguments->options.force, "replace the file");
  return {verb, OnRanks([arguments](Environment& environment) {
            const RunOptions& options = arguments->options;
            const Case run_case = case_of(*arguments, environment);
            if (run_case.has_mesh_file() != options.output.empty())
              throw Error(ExitCode::usage, run_case.has_mesh_file()
                                               ? "the deck's mesh is a file already; leave out -o"
                                               : "where to? Give a file for the mesh: -o FILE");
            if (!options.output.empty() && !options.force)
              refuse_existing(environment.communicator(), options.output);
            return print(environment, make_mesh(run_case, options.output));
          })};
}

}  // namespace

std::vector<Verb> run_verbs(CLI::App& app) {
  return {run_verb(app), restart_verb(app), check_verb(app), jacobian_verb(app), mesh_verb(app)};
}

}  // namespace hawser::program
