#include "hawser/simulation/simulation.hpp"

#include <Tpetra_Vector.hpp>

#include <filesystem>

#include "hawser/base/error.hpp"
#include "hawser/simulation/deck_language.hpp"
#include "src/progress.hpp"
#include "src/provenance.hpp"
#include "src/run_case.hpp"
#include "src/run_record.hpp"
#include "src/run_signals.hpp"
#include "src/state_checkpoint.hpp"

namespace hawser {

struct Simulation::Implementation {
  Communicator communicator;
  ModuleRegistry registry;
  RunOptions options;
  RunCase run_case;
  std::unique_ptr<CheckpointReader> checkpoint;  // when restarted
  std::filesystem::path home;                    // the checkpoint's folder

  std::unique_ptr<System> system;
  std::unique_ptr<StepControl> steps;
  std::unique_ptr<RunRecord> record;
  std::unique_ptr<Progress> progress;
  Stopwatch newton_watch, setup_watch;

  Implementation(const Communicator& comm, ModuleRegistry known, RunOptions wanted)
      : communicator(comm), registry(std::move(known)), options(std::move(wanted)) {}

  const RunDeck& deck() const { return run_case.deck; }
  double now() const { return system->integrator->history().time; }

  void read(Deck text, Diagnostics& diagnostics) {
    run_case = read_case(communicator, std::move(text), options, registry, diagnostics);
  }

  /// A restarted run continues the results beside its checkpoint; elsewhere it needs --force, like
  /// any run, to replace others.
  ExistingResults existing_results() const {
    std::error_code none;
    if (checkpoint && std::filesystem::equivalent(options.output, home, none))
      return ExistingResults::go_on;
    return options.force ? ExistingResults::replace : ExistingResults::keep;
  }

  // A restarted run uses the very mesh of the run that it continues.
  std::string provide_mesh(const ResultFolder& folder) const {
    if (checkpoint) return (home / checkpoint->header().texts.at("mesh")).string();
    const ProvidedMesh mesh = hawser::provide_mesh(communicator, run_case, folder.file("mesh.msh"));
    if (!mesh.made.empty()) progress->note(mesh.made);
    return mesh.file;
  }

  void set_up(const ResultFolder& folder) {
    const auto lap = setup_watch.lap();
    progress = std::make_unique<Progress>(communicator, options.quiet);
    std::string mesh_file;
    try {
      mesh_file = provide_mesh(folder);
      system = build_system(communicator, deck(), std::move(run_case.modules), mesh_file);
    } catch (const MeshError& error) {
      throw MeshError(deck().mesh.location.text() + ": " + error.what());
    }
    steps = std::make_unique<StepControl>(
        deck().time, deck().time.steady() ? std::vector<double>() : system->conditions->events());
    if (checkpoint) {
      system->integrator->resume(load_history(*system->dofs, *checkpoint));
      const auto& numbers = checkpoint->header().numbers;
      steps->resume(numbers.at("control_step_s"),
                    static_cast<int>(numbers.at("control_successes")));
    }
    record = std::make_unique<RunRecord>(*system, run_case, folder, mesh_file, checkpoint.get());
    folder.write("resolved.xml", resolved(run_case.text, registry));
    progress->start(*system, deck());
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
    result.local_error = system->integrator->local_error(problem.state());
    result.linear_iterations = report.linear_iterations;
    progress->solved(report);
    return result;
  }

  /// One attempt; none when it was rejected and a shorter step is to be tried. When there is no
  /// shorter one: a checkpoint, and SolveError.
  std::optional<StepFigures> advance() {
    const double length = steps->next(now(), system->integrator->history().step);
    try {
      StepFigures result = attempt(length);
      const StepOutcome outcome{result.local_error, result.newton_iterations};
      if (steps->is_too_inaccurate(outcome) && steps->rejected(length, outcome)) {
        record->rejected();
        progress->rejected(now(), length, "local error " + write_value(*result.local_error));
        return std::nullopt;
      }
      steps->accepted(length, outcome);
      return result;
    } catch (const SolveError& error) {
      record->rejected();
      progress->rejected(now(), length, error.what());
      if (deck().time.steady()) throw;
      if (steps->rejected(length)) return std::nullopt;
      throw SolveError(std::string(error.what()) +
                       "; the least step was reached, the last accepted state is in " +
                       record->save_checkpoint(*steps));
    }
  }

  void obey(const Request& request) {
    if (request.kind == Request::Kind::none) return;
    const std::string checkpoint_file = record->save_checkpoint(*steps);
    const std::string time = "t = " + write_value(now()) + " s";
    if (request.kind == Request::Kind::checkpoint)
      return progress->note(request.signal + ": checkpoint of " + time + " in " + checkpoint_file);
    throw Error(ExitCode::stopped, "stopped by " + request.signal + " at " + time +
                                       "; go on with: hawser restart " + checkpoint_file +
                                       (options.end ? " --end " + write_value(*options.end) : ""));
  }

  Summary run() {
    // What comes while the mesh is made is obeyed afterwards.
    const RunSignals signals(communicator);
    const ResultFolder folder(communicator, options.output, existing_results());
    set_up(folder);
    while (!steps->finished(now())) {
      obey(signals.take());
      std::optional<StepFigures> figures = advance();
      if (!figures) continue;
      system->problem->accept();
      record->accepted(*figures);
      progress->stepped(*figures, deck().time.end);
      record->write(*figures, *steps, steps->finished(now()));
    }
    return summarise(folder);
  }

  Summary summarise(const ResultFolder& folder) {
    Summary summary = record->summary();
    Summary& timings = summary.object("timings");
    timings.set("setup_s", setup_watch.seconds());
    timings.set("residual_s", system->problem->residual_seconds());
    timings.set("tangent_s", system->problem->tangent_seconds());
    timings.set("linear_solve_s", newton_watch.seconds() - system->problem->residual_seconds() -
                                      system->problem->tangent_seconds());
    timings.set("output_s", record->seconds());
    summary.set("wall_s", setup_watch.seconds() + progress->elapsed());
    add_provenance(communicator, summary);
    check_expectations(deck(), summary);
    summary.write(communicator, folder.file("summary.json"));
    progress->finish(*system, deck(), summary, folder.path());
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
  implementation_->read(read_deck(communicator, deck_file, options.changes,
                                  deck_language(implementation_->registry), diagnostics),
                        diagnostics);
}

Simulation Simulation::restart(const Communicator& communicator, ModuleRegistry registry,
                               const std::string& checkpoint, const RunOptions& options) {
  auto implementation =
      std::make_unique<Implementation>(communicator, std::move(registry), options);
  implementation->checkpoint = std::make_unique<CheckpointReader>(communicator, checkpoint);
  const CheckpointHeader& header = implementation->checkpoint->header();
  implementation->home = std::filesystem::absolute(checkpoint).parent_path();
  if (options.output.empty()) implementation->options.output = implementation->home.string();
  Diagnostics diagnostics;
  implementation->read(
      parse_deck(header.texts.at("deck"), header.texts.at("deck_file"), diagnostics), diagnostics);
  if (StepControl(implementation->deck().time, {}).finished(header.time))
    throw Error(ExitCode::usage, checkpoint + " is at t = " + write_value(header.time) +
                                     " s, and the run ends at " +
                                     write_value(implementation->deck().time.end) +
                                     " s: nothing is left to do; --end sets a later end");
  return Simulation(std::move(implementation));
}

Summary Simulation::run() { return implementation_->run(); }
std::string Simulation::resolved_deck() const {
  return resolved(implementation_->run_case.text, implementation_->registry);
}

}  // namespace hawser
