#include "hawser/simulation/simulation.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "hawser/base/error.hpp"
#include "hawser/output/result_folder.hpp"
#include "hawser/simulation/plugin_loader.hpp"
#include "src/field_output.hpp"
#include "src/mesh_monitor.hpp"
#include "src/progress.hpp"
#include "src/provenance.hpp"
#include "src/run_summary.hpp"
#include "src/state_checkpoint.hpp"
#include "src/system.hpp"

namespace hawser {
namespace {

constexpr const char* checkpoint_name = "checkpoint.h5";

}  // namespace

struct Simulation::Implementation {
  Communicator communicator;
  ModuleRegistry registry;
  RunOptions options;
  Deck deck_text;
  RunDeck deck;
  std::vector<PhysicsModule> modules;
  std::unique_ptr<CheckpointReader> checkpoint;  // when restarted
  std::filesystem::path home;                    // the checkpoint's folder
  std::filesystem::path mesh_file;

  std::unique_ptr<System> system;
  std::unique_ptr<StepControl> steps;
  std::unique_ptr<FieldOutput> fields;
  std::unique_ptr<Histories> histories;
  std::unique_ptr<Progress> progress;
  RunSummary figures;
  int step = 0;
  Stopwatch newton_watch, output_watch, setup_watch;

  Implementation(const Communicator& comm, ModuleRegistry known, RunOptions wanted)
      : communicator(comm), registry(std::move(known)), options(std::move(wanted)) {}

  void read(Deck text, Diagnostics& diagnostics) {
    deck_text = std::move(text);
    deck = RunDeck::spec().read(deck_text.root, diagnostics);
    if (options.end) deck.time.end = *options.end;
    if (deck.time.steady) deck.time.step = deck.time.end;
    if (deck.time.least == 0) deck.time.least = deck.time.step / 1000;
    for (const PluginDeck& plugin : deck.plugins) {
      const std::string where = plugin.name.location.text();
      communicator.together([&] {
        try {
          load_plugin(plugin.name.value, options.plugin_folder, registry);
        } catch (const PluginError& error) {
          throw PluginError(where + ": " + error.what());
        }
      });
    }
    for (const DeckNode& node : deck.modules.modules) {
      if (!is_known_child(node, "modules", registry.tags(), diagnostics)) continue;
      modules.push_back(registry.find(node.tag)->make(node, diagnostics));
      modules.back().location = node.location;
    }
    if (modules.empty() && diagnostics.ok())
      diagnostics.error(deck_text.root.find_child("modules")->location,
                        "<modules> is empty; there are " + listed(registry.tags()));
    diagnostics.throw_if_any();
  }

  std::string resolved() const {
    return hawser::resolved_deck(deck_text.root, RunDeck::spec().node_spec(),
                                 [&](const std::string& tag) {
                                   const ModuleRegistry::Entry* const entry = registry.find(tag);
                                   return entry == nullptr ? nullptr : &entry->spec;
                                 });
  }

  // A restarted run uses the very mesh of the run that it continues.
  std::string provide_mesh(const ResultFolder& folder) const {
    if (checkpoint) return (home / checkpoint->header().texts.at("mesh")).string();
    if (deck.mesh.file) {
      const std::filesystem::path name = deck.mesh.file->name;
      return name.is_absolute()
                 ? name.string()
                 : (std::filesystem::path(deck_text.file).parent_path() / name).string();
    }
    const std::string file = folder.file("mesh.msh");
    progress->note(deck.mesh.tow_box
                       ? generate_mesh(communicator, deck.mesh.tow_box->box(), file)
                       : generate_mesh(communicator, deck.mesh.water_box->box(), file));
    return std::filesystem::absolute(file).string();
  }

  void set_up(const ResultFolder& folder) {
    const auto lap = setup_watch.lap();
    progress = std::make_unique<Progress>(communicator, options.quiet);
    try {
      const std::string file = provide_mesh(folder);
      mesh_file = std::filesystem::absolute(file);
      system = build_system(communicator, deck, std::move(modules), file);
    } catch (const MeshError& error) {
      throw MeshError(deck.mesh.location.text() + ": " + error.what());
    }
    steps = std::make_unique<StepControl>(
        deck.time, deck.time.steady ? std::vector<double>() : system->conditions->events());
    std::optional<double> keep_until;
    if (checkpoint) {
      system->integrator->resume(load_history(*system->dofs, *checkpoint));
      step = checkpoint->header().step;
      const CheckpointHeader& header = checkpoint->header();
      steps->resume(header.numbers.at("control_step_s"),
                    static_cast<int>(header.numbers.at("control_successes")));
      figures.resume(header);
      keep_until = header.time;
    }
    fields = std::make_unique<FieldOutput>(*system->assembler, system->tow.get(), folder.path(),
                                           checkpoint ? step : -1);
    histories = std::make_unique<Histories>(communicator, folder.path(), system->tow.get(),
                                            system->forces, system->probes, keep_until);
    folder.write("resolved.xml", resolved());
    progress->start(*system, deck, modules_text());
  }

  /// A restarted run continues the results beside its checkpoint; elsewhere it needs --force, like
  /// any run, to replace finished ones.
  void go_on_in(const std::filesystem::path& folder) {
    home = folder;
    if (options.output.empty()) options.output = home.string();
    std::error_code none;
    if (std::filesystem::equivalent(options.output, home, none)) options.force = true;
  }

  std::string modules_text() const {
    std::vector<std::string> names;
    for (const PhysicsModule& module : system->modules)
      names.push_back(module.name);
    return listed(names);
  }

  void save_checkpoint(const ResultFolder& folder) {
    CheckpointHeader header;
    header.step = step;
    header.numbers["control_step_s"] = steps->step();
    header.numbers["control_successes"] = steps->successes();
    figures.save(header);
    header.texts["deck"] = deck_text.text;
    header.texts["deck_file"] = deck_text.file;
    // A mesh beside the checkpoint is named without its folder, so that both can be moved.
    const bool beside = mesh_file.parent_path() == std::filesystem::absolute(folder.path());
    header.texts["mesh"] = (beside ? mesh_file.filename() : mesh_file).string();
    save_history(*system->dofs, system->integrator->history(), header,
                 folder.file(checkpoint_name));
    // A restarted run begins without a Jacobian or factor; to be equal to it, this one must too.
    system->driver->forget();
  }

  /// One attempt at a step; SolveError when there is no solution to be had.
  StepFigures attempt(double length) {
    const auto lap = newton_watch.lap();
    CoupledProblem& problem = *system->problem;
    problem.begin_step(length);
    TpetraVector x(problem.system().rows);
    problem.copy_guess(x);
    const NonlinearReport report = system->driver->solve(x);
    problem.finish_step(x);
    StepFigures result;
    result.newton_iterations = report.iterations;
    result.linear_iterations = report.linear_iterations;
    progress->solved(report);
    return result;
  }

  /// Steps until one is accepted; writes a checkpoint and throws when the least step fails too.
  StepFigures advance(const ResultFolder& folder) {
    while (true) {
      const TimeHistory& history = system->integrator->history();
      const double length = steps->next(history.time, history.step);
      try {
        StepFigures result = attempt(length);
        steps->accepted();
        return result;
      } catch (const SolveError& error) {
        figures.rejected();
        progress->rejected(system->integrator->history().time, length, error.what());
        if (!deck.time.steady && steps->rejected(length)) continue;
        if (!deck.time.steady) save_checkpoint(folder);
        throw SolveError(std::string(error.what()) +
                         (deck.time.steady
                              ? std::string()
                              : "; the least step was reached, the last accepted state is in " +
                                    folder.file(checkpoint_name)));
      }
    }
  }

  void measure(StepFigures& result) {
    const State& state = system->problem->state();
    result.step = step;
    result.time = state.time;
    result.length = system->integrator->history().step;
    const MeshFigures mesh = inspect_mesh(*system->dofs, state);
    result.mesh_quality = mesh.least_quality;
    result.courant = mesh.courant;
    if (system->tow) result.tow = system->tow->measure(state, system->problem->reactions());
    for (const ForceReport& force : system->forces)
      result.forces.push_back(force.measure(state, system->problem->reactions()));
    for (const Probe& probe : system->probes)
      for (int c = 0; c < probe.components; ++c)
        result.probes.push_back(communicator.sum(
            probe.first_row < 0 ? 0.0
                                : state.value[static_cast<std::size_t>(probe.first_row + c)]));
  }

  void write(const ResultFolder& folder, const StepFigures& result, bool last) {
    const auto lap = output_watch.lap();
    const auto due = [&](int every) { return every > 0 && step % every == 0; };
    if (due(deck.output.history_every) || last) histories->append(result);
    if (due(deck.output.fields_every) || last) {
      fields->write(step, system->problem->state());
      histories->append_cable(system->problem->state());
    }
    if (due(deck.output.checkpoint_every)) save_checkpoint(folder);
  }

  Summary run() {
    const ResultFolder folder(communicator, options.output, options.force);
    set_up(folder);
    while (!steps->finished(system->integrator->history().time)) {
      StepFigures result = advance(folder);
      system->integrator->accept(system->problem->state());
      ++step;
      measure(result);
      figures.add(result);
      progress->stepped(result, deck.time.end);
      write(folder, result, steps->finished(system->integrator->history().time));
    }
    return summarise(folder);
  }

  Summary summarise(const ResultFolder& folder) {
    Summary summary = figures.summary(*system, deck);
    Summary& timings = summary.object("timings");
    timings.set("setup_s", setup_watch.seconds());
    timings.set("residual_s", system->problem->residual_seconds());
    timings.set("tangent_s", system->problem->tangent_seconds());
    timings.set("linear_solve_s", newton_watch.seconds() - system->problem->residual_seconds() -
                                      system->problem->tangent_seconds());
    timings.set("output_s", output_watch.seconds());
    summary.set("wall_s", setup_watch.seconds() + progress->elapsed());
    add_provenance(communicator, summary);
    check_expectations(deck, summary);
    summary.write(communicator, folder.file("summary.json"));
    progress->finish(*system, deck, summary, folder.path());
    return summary;
  }
};

Simulation::Simulation(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;

Simulation::Simulation(const Communicator& communicator, ModuleRegistry registry,
                       const std::string& deck_file, const RunOptions& options)
    : implementation_(
          std::make_unique<Implementation>(communicator, std::move(registry), options)) {
  Diagnostics diagnostics;
  implementation_->read(read_deck(communicator, deck_file, diagnostics), diagnostics);
}

Simulation Simulation::restart(const Communicator& communicator, ModuleRegistry registry,
                               const std::string& checkpoint, const RunOptions& options) {
  auto implementation =
      std::make_unique<Implementation>(communicator, std::move(registry), options);
  implementation->checkpoint = std::make_unique<CheckpointReader>(communicator, checkpoint);
  const CheckpointHeader& header = implementation->checkpoint->header();
  implementation->go_on_in(std::filesystem::absolute(checkpoint).parent_path());
  Diagnostics diagnostics;
  implementation->read(
      parse_deck(header.texts.at("deck"), header.texts.at("deck_file"), diagnostics), diagnostics);
  if (StepControl(implementation->deck.time, {}).finished(header.time))
    throw Error(ExitCode::usage, checkpoint + " is at t = " + write_value(header.time) +
                                     " s, and the run ends at " +
                                     write_value(implementation->deck.time.end) +
                                     " s: nothing is left to do; --end sets a later end");
  return Simulation(std::move(implementation));
}

Summary Simulation::run() { return implementation_->run(); }
std::string Simulation::resolved_deck() const { return implementation_->resolved(); }

}  // namespace hawser
