// Observed orders of accuracy.
#include <cstdio>
#include <map>

#include "figure_script.hpp"
#include "hawser/base/child_process.hpp"
#include "hawser/base/error.hpp"
#include "hawser/simulation/convergence.hpp"
#include "run_options.hpp"
#include "verb.hpp"

namespace hawser::program {
namespace {

/// A plot beside the table. What was computed stays when it cannot be drawn.
void draw(const std::string& folder, bool is_quiet) {
  try {
    const ChildResult drawn =
        run_child("/usr/bin/python3", {figure_script("convergence_figure.py"), folder});
    if (drawn.status != 0)
      std::fprintf(stderr, "no plot: %s", drawn.errors.c_str());
    else if (!is_quiet)
      std::fputs(drawn.output.c_str(), stdout);
  } catch (const OutputError& error) {
    std::fprintf(stderr, "no plot: %s\n", error.what());
  }
}

}  // namespace

std::vector<Verb> converge_verbs(CLI::App& app) {
  struct Arguments {
    std::string deck, plugin_folder;
    ConvergenceOptions options;
  };
  const auto arguments = std::make_shared<Arguments>();
  ConvergenceOptions& options = arguments->options;
  auto* verb = app.add_subcommand(
      "converge", "run a deck on ever finer meshes or with ever shorter steps, and report orders");
  verb->add_option("deck", arguments->deck, "XML deck with <error> elements")->required();
  add_changes(*verb, options.changes);
  verb->add_option("-o,--output", options.run.output, "folder for the results")->required();
  const std::map<std::string, Refinement> words = {
      {"space", Refinement::space}, {"time", Refinement::time}, {"both", Refinement::both}};
  verb->add_option("--refine", options.refine, "instead of the deck's <converge refine>")
      ->transform(CLI::CheckedTransformer(words));
  verb->add_option("--levels", options.levels, "instead of the deck's <converge levels>")
      ->check(CLI::Range(2, 12));
  add_plugin_folder(*verb, arguments->plugin_folder);
  verb->add_flag("-f,--force", options.run.force, "write over the results of a finished study");
  verb->add_flag_callback(
      "-q,--quiet", [&options] { options.run.detail = LogDetail::quiet; }, "no table");
  verb->footer("Example: hawser converge DECK -o results/orders --refine space --levels 4");
  return {{verb, OnRanks([arguments](Environment& environment) {
             environment.plugin_folder = arguments->plugin_folder;
             const Summary result = converge(environment, arguments->deck, arguments->options);
             const RunOptions& of_run = arguments->options.run;
             if (environment.communicator().is_root())
               draw(of_run.output, of_run.detail == LogDetail::quiet);
             return static_cast<int>(result.number("orders_failed").value_or(0) > 0
                                         ? ExitCode::expectation
                                         : ExitCode::done);
           })}};
}

}  // namespace hawser::program
