// A measured line replayed: navigation in, a deck, its run, and how far it is from what was
// measured.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <sstream>

#include "figure_script.hpp"
#include "hawser/base/child_process.hpp"
#include "hawser/base/error.hpp"
#include "hawser/deck/input_files.hpp"
#include "hawser/deck/named_value.hpp"
#include "hawser/deck/value.hpp"
#include "hawser/replay/fit.hpp"
#include "replay_model.hpp"
#include "replay_results.hpp"
#include "run_options.hpp"
#include "verb.hpp"

namespace hawser::program {
namespace {

struct Arguments {
  std::string file, output, with, plugin_folder, command;
  NavigationOptions navigation;
  LineOptions line;
  ReplayDeckOptions deck;
  std::vector<DeckChange> changes;
  std::vector<std::string> fit;
  bool force = false, quiet = false;
};

ReplayParameter& parameter_named(std::vector<ReplayParameter>& parameters, const std::string& name,
                                 const std::string& asked_by, bool to_fit) {
  std::vector<std::string> names;
  for (ReplayParameter& parameter : parameters) {
    if (parameter.name == name && (parameter.may_be_fitted || !to_fit)) return parameter;
    if (parameter.may_be_fitted || !to_fit) names.push_back(parameter.name);
  }
  throw Error(ExitCode::usage, asked_by + ": there is no '" + name + "'; there are " +
                                   listed(names) + did_you_mean(name, names));
}

class Replay {
 public:
  Replay(const Arguments& arguments, Environment& environment)
      : arguments_(arguments), environment_(environment), world_(environment.communicator()) {
    environment.plugin_folder = arguments.plugin_folder;
  }

  int run() {
    set_parameters();
    read_line();
    for (const std::string& note : line_.notes)
      tell(note + "\n");
    make_folder();
    write_deck();
    state_in_si_units();
    ReplayResults results{line_, parameters_};
    results.path_positions = follow_the_path(line_);
    results.path = compare(line_, results.path_positions);
    if (arguments_.fit.empty())
      take(run_with({}, {}), results);
    else
      fit(results);
    results.model = compare(line_, results.positions);
    world_.on_root([&] { write_results(arguments_.output, results); });
    tell(told_results(results));
    draw();
    tell("deck: " + deck_file() + "\n");
    return 0;
  }

 private:
  std::string deck_file() const { return arguments_.output + "/deck.xml"; }
  void tell(const std::string& text) const {
    if (world_.is_root() && !arguments_.quiet)
      std::fputs(text.c_str(), stdout), std::fflush(stdout);
  }

  void set_parameters() {
    parameters_ = replay_parameters();
    if (!arguments_.with.empty()) {
      std::string found;
      world_.on_root([&] {
        for (const auto& [name, value] : earlier_parameters(arguments_.with))
          found += name + "=" + write_value(value) + "\n";
      });
      std::istringstream lines(world_.broadcast(found));
      for (std::string one; std::getline(lines, one);) {
        const DeckChange change = read_change(one);
        parameter_named(parameters_, change.path, arguments_.with + "/replay.json", false).value =
            change.value;
      }
    }
    for (const DeckChange& change : arguments_.changes)
      parameter_named(parameters_, change.path, "--set", false).value = change.value;
    for (const std::string& name : arguments_.fit)
      parameter_named(parameters_, name, "--fit", true);
  }

  void read_line() {
    Diagnostics diagnostics;
    const auto text = InputFiles(world_).read(arguments_.file);
    if (!text) throw OutputError("cannot read " + arguments_.file);
    const NavigationLine line =
        read_navigation(*text, arguments_.file, arguments_.navigation, diagnostics);
    diagnostics.throw_if_any();
    line_ = prepare_line(line, arguments_.line, diagnostics);
    diagnostics.throw_if_any();
    tell(fmt::format(
        "{}: {}, {} shots of {} receivers, a cable of {:.5g} m, {:.0f} s at {:.3g} m/s\n",
        line_.file, line_.format, line_.times.size(), line_.receivers.size(), line_.length(),
        line_.times.back(), line_.speed));
  }

  void make_folder() const {
    world_.on_root([&] {
      namespace fs = std::filesystem;
      std::error_code failed;
      if (fs::exists(arguments_.output + "/replay.json") && !arguments_.force)
        throw OutputError(arguments_.output +
                          " holds a replay already; choose another folder, or "
                          "--force to replace it");
      fs::create_directories(arguments_.output, failed);
      if (failed)
        throw OutputError("cannot make the folder " + arguments_.output + ": " + failed.message());
      write_text(arguments_.output + "/head.csv", head_csv(line_));
      write_text(arguments_.output + "/shape.csv", shape_csv(line_));
    });
  }

  void write_deck() {
    ReplayDeckOptions options = arguments_.deck;
    options.made_by = arguments_.command;
    world_.on_root([&] { write_text(deck_file(), replay_deck(line_, parameters_, options)); });
  }

  /// What units parameters were given in the deck knows to convert; here on they are SI.
  void state_in_si_units() {
    const Case read = Case::from_file(environment_, deck_file());
    for (ReplayParameter& parameter : parameters_)
      state(parameter.name, find_named(read.text().root.names.get(), parameter.name)->value);
    write_deck();
  }
  void state(const std::string& name, double value) {
    ReplayParameter& parameter = parameter_named(parameters_, name, "", false);
    parameter.value = write_value(value) + (parameter.unit == "1" ? "" : " " + parameter.unit);
  }
  /// SI.
  static std::vector<double> values_of(const std::vector<ReplayParameter>& wanted) {
    std::vector<double> values;
    for (const ReplayParameter& parameter : wanted)
      values.push_back(si_value(parameter));
    return values;
  }

  ModelRun run_with(const std::vector<ReplayParameter>& wanted,
                    const std::vector<double>& values) const {
    std::vector<DeckChange> changes;
    for (std::size_t i = 0; i < values.size(); ++i)
      changes.push_back({wanted[i].name, write_value(values[i])});
    return run_model(environment_, deck_file(), changes, line_);
  }
  static void take(ModelRun run, ReplayResults& results) {
    results.cpu_seconds = run.cpu_seconds;
    results.steps = run.steps;
    results.positions = std::move(run.positions);
  }

  void fit(ReplayResults& results) {
    for (const std::string& name : arguments_.fit)
      results.fitted.push_back(parameter_named(parameters_, name, "--fit", true));
    const std::vector<ReplayParameter>& fitted = results.fitted;
    const ReplayModel model = [&](const std::vector<double>& values) {
      take(run_with(fitted, values), results);
      return results.positions;
    };
    const FitResult found =
        fit_parameters(line_, fitted, values_of(fitted), model, [&](const FitIteration& now) {
          std::string text = fmt::format("fit: rms {:.2f} m", now.rms);
          for (std::size_t i = 0; i < now.values.size(); ++i)
            text += fmt::format(", {} {:.5g}", fitted[i].name, now.values[i]);
          tell(text + "\n");
        });
    for (std::size_t i = 0; i < fitted.size(); ++i)
      state(fitted[i].name, found.values[i]);
    write_deck();  // with what was found, beside which the others are changed
    results.positions = found.positions;
    std::vector<ReplayParameter> all;
    for (const ReplayParameter& parameter : parameters_)
      if (parameter.may_be_fitted) all.push_back(parameter);
    const auto cosines = likeness(
        line_, found.positions, all, values_of(all),
        [&](const std::vector<double>& values) { return run_with(all, values).positions; });
    results.told = what_cannot_be_told(fitted, found, all, cosines);
    results.fit = found;
  }

  void draw() const {
    if (!world_.is_root()) return;
    try {
      const ChildResult drawn =
          run_child("/usr/bin/python3", {figure_script("replay_figure.py"), arguments_.output});
      if (drawn.status != 0)
        std::fprintf(stderr, "no figures: %s", drawn.errors.c_str());
      else
        tell(drawn.output);
    } catch (const OutputError& error) {
      std::fprintf(stderr, "no figures: %s\n", error.what());
    }
  }

  const Arguments& arguments_;
  Environment& environment_;
  const Communicator& world_;
  MeasuredLine line_;
  std::vector<ReplayParameter> parameters_;
};

}  // namespace

std::vector<Verb> replay_verbs(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  auto* verb = app.add_subcommand(
      "replay", "make a deck of a measured line, run it, and compare it with what was measured");
  verb->footer(
      "Example: hawser replay line.p190 -o results/line --set diameter=\"54 mm\" --fit "
      "ct,current_east,current_north\n"
      "         hawser replay next.p190 -o results/next --with results/line\n"
      "Parameters: ct cn ca diameter mass stiffness density tail_drag_area current_east "
      "current_north.");
  verb->add_option("navigation", arguments->file,
                   "positions of receivers: CSV (shot,receiver,east_m,north_m) or P1/90")
      ->required();
  verb->add_option("-o,--output", arguments->output, "folder for deck and results")->required();
  verb->add_option("--speed", arguments->line.speed,
                   "m/s along the head's track, if the file has no times")
      ->check(CLI::PositiveNumber);
  verb->add_option("--spacing", arguments->line.spacing,
                   "m between receivers of successive numbers")
      ->check(CLI::PositiveNumber);
  verb->add_option("--streamer", arguments->navigation.streamer,
                   "which one, if the file has several");
  verb->add_option("--smooth", arguments->line.smooth,
                   "s, of the head's track; else by its scatter")
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--shape-smooth", arguments->line.shape_smooth,
                   "m, of the shape at the first shot; else six distances of receivers")
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--longest-gap", arguments->line.longest_gap,
                   "s without the head that are bridged")
      ->check(CLI::PositiveNumber);
  verb->add_option("--segments", arguments->deck.segments, "of the cable")
      ->check(CLI::Range(2, 100000));
  verb->add_option("--step", arguments->deck.step, "s, of the run")->check(CLI::PositiveNumber);
  verb->add_option("--fit", arguments->fit,
                   "parameters to be found, such as ct,current_east,current_north")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--with", arguments->with,
                   "folder of an earlier replay, whose parameters are taken");
  add_changes(*verb, arguments->changes);
  add_plugin_folder(*verb, arguments->plugin_folder);
  verb->add_flag("-f,--force", arguments->force, "replace an earlier replay");
  verb->add_flag("-q,--quiet", arguments->quiet, "tell what goes wrong only");
  return {{verb, OnRanks([arguments](Environment& environment) {
             arguments->command = "hawser replay " + arguments->file;
             return Replay(*arguments, environment).run();
           })}};
}

}  // namespace hawser::program
