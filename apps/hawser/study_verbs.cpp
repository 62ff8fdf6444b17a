// Studies: many runs, and the report on them.
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "figure_script.hpp"
#include "hawser/base/error.hpp"
#include "hawser/simulation/case.hpp"
#include "hawser/study/study.hpp"
#include "run_options.hpp"
#include "verb.hpp"

namespace hawser::program {
namespace {

std::filesystem::path this_program() { return std::filesystem::read_symlink("/proc/self/exe"); }

struct StudyArguments {
  StudyOptions study;
  std::string plugin_folder;
};

ResolveDeck resolver(const Environment& environment) {
  return
      [&](const std::string& deck, const std::vector<std::pair<std::string, std::string>>& values) {
        CaseOptions of_case;
        for (const auto& [path, value] : values)
          of_case.changes.push_back({path, value});
        return Case::from_file(environment, deck, of_case).resolved_deck();
      };
}

int run(const StudyArguments& arguments, Environment& environment) {
  environment.plugin_folder = arguments.plugin_folder;
  StudyOptions options = arguments.study;
  options.program = this_program().string();
  options.run_arguments = {"--plugin-dir", arguments.plugin_folder};
  const StudyResult result = run_study(options, resolver(environment));
  if (!options.quiet)
    std::printf(
        "%d cases finished, %d of them before; %d failed; %d not run\nreport: %s report %s\n",
        result.finished, result.kept, result.failed, result.waiting, options.program.c_str(),
        options.output.c_str());
  if (result.waiting > 0) return static_cast<int>(ExitCode::stopped);
  return static_cast<int>(result.failed > 0 ? ExitCode::not_converged : ExitCode::done);
}

/// Becomes the script; returns only when that cannot be started.
int report(const std::string& folder) {
  const std::string script = figure_script("study_report.py");
  execl("/usr/bin/python3", "python3", script.c_str(), folder.c_str(), nullptr);
  throw OutputError("cannot run /usr/bin/python3 " + script + ": " + std::strerror(errno));
}

Verb study_verb(CLI::App& app) {
  auto* verb = app.add_subcommand("study", "run every case of a study, side by side");
  verb->footer(
      "Cases that have results of the very deck are not run again: repeat it after an "
      "interruption.\n"
      "Example: hawser study inputs/deep_tow/study_quick.xml -o results/study_quick");
  const auto arguments = std::make_shared<StudyArguments>();
  StudyOptions& options = arguments->study;
  verb->add_option("study", options.file, "XML study")->required();
  verb->add_option("-o,--output", options.output, "folder for the results")->required();
  verb->add_option("-j,--jobs", options.jobs,
                   "runs at a time; else as many as there are processors")
      ->check(CLI::Range(1, 10000));
  verb->add_flag("-f,--force", options.fresh, "run finished cases again");
  verb->add_flag("-q,--quiet", options.quiet, "no progress lines");
  add_plugin_folder(*verb, arguments->plugin_folder);
  return {verb,
          Alone([arguments](Environment& environment) { return run(*arguments, environment); })};
}

Verb report_verb(CLI::App& app) {
  auto* verb = app.add_subcommand("report", "a page with tables and figures on a study's results");
  const auto folder = std::make_shared<std::string>();
  verb->add_option("folder", *folder, "results of a study")->required();
  verb->footer("Example: hawser report results/study_quick");
  return {verb, Alone([folder](const Environment&) { return report(*folder); })};
}

}  // namespace

std::optional<std::string> check_study(const Environment& environment, const std::string& file) {
  Diagnostics none;
  if (read_deck(environment.communicator(), file, none).root.tag != "study") return std::nullopt;
  const CheckedStudy found = read_study(environment.communicator(), file, resolver(environment));
  return file + ": no faults in the study and its " + std::to_string(found.cases.size()) +
         " cases (names of regions and fields are checked when they run)\n";
}

std::vector<Verb> study_verbs(CLI::App& app) { return {study_verb(app), report_verb(app)}; }

}  // namespace hawser::program
