#include "hawser/simulation/simulation.hpp"

#include <filesystem>

#include "hawser/base/error.hpp"
#include "hawser/base/scratch_folder.hpp"
#include "hawser/base/signals.hpp"
#include "hawser/output/provenance.hpp"
#include "hawser/simulation/deck_language.hpp"
#include "hawser/time/state_checkpoint.hpp"
#include "src/preview.hpp"
#include "src/run_case.hpp"
#include "src/run_log.hpp"
#include "src/run_record.hpp"

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
  std::unique_ptr<RunLog> log;
  Stopwatch setup_watch, run_watch, newton_watch;

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
  std::string provide_mesh(const std::string& place) const {
    if (checkpoint) return (home / checkpoint->header().texts.at("mesh")).string();
    const ProvidedMesh mesh = hawser::provide_mesh(communicator, run_case, place);
    if (log && !mesh.made.empty()) log->note(mesh.made);
    return mesh.file;
  }

  /// `place` is for a mesh that must be made.
  std::string build(const std::string& place) {
    try {
      std::string file = provide_mesh(place);
      system = build_system(communicator, deck(), std::move(run_case.modules), file);
      return file;
    } catch (const MeshError& error) {
      throw MeshError(deck().mesh.location.text() + ": " + error.what());
    }
  }

  void set_up(const ResultFolder& folder) {
    const auto lap = setup_watch.lap();
    log = make_run_log(communicator, options);
    const std::string mesh_file = build(folder.file("mesh.msh"));
    steps = std::make_unique<StepControl>(
        deck().time, deck().time.steady() ? std::vector<double>() : system->conditions->events());
    if (checkpoint) {
      system->integrator->resume(load_history(*system->dofs, *checkpoint));
      const auto& numbers = checkpoint->header().numbers;
      steps->resume(numbers.at("control_step_s"),
                    static_cast<int>(numbers.at("control_successes")));
    }
    record =
        std::make_unique<RunRecord>(*system, run_case, folder, mesh_file, *log, checkpoint.get());
    folder.write("resolved.xml", resolved(run_case.text, registry));
    log->start(*system, deck(), folder.path());
  }

  /// One attempt at a step; SolveError when there is no solution to be had.
  StepFigures attempt(double length) {
    const auto lap = newton_watch.lap();
    CoupledProblem& problem = *system->problem;
    problem.begin_step(length);
    const auto x = problem.guess();
    const NonlinearReport report = system->driver->solve(*x);
    problem.finish_step(*x);
    StepFigures result;
    result.newton_iterations = report.iterations;
    result.local_error = system->integrator->local_error(problem.state());
    result.linear_iterations = report.linear_iterations;
    log->solved(report);
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
        log->rejected(now(), length, "local error " + write_value(*result.local_error));
        return std::nullopt;
      }
      steps->accepted(length, outcome);
      return result;
    } catch (const SolveError& error) {
      record->rejected();
      log->rejected(now(), length, error.what());
      // One steady solve has no shorter step to try; load steps have.
      if (deck().time.steady() && deck().time.step == deck().time.end) throw;
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
      return log->note(request.signal + ": checkpoint of " + time + " in " + checkpoint_file);
    throw Error(ExitCode::stopped, "stopped by " + request.signal + " at " + time +
                                       "; go on with: hawser restart " + checkpoint_file +
                                       (options.end ? " --end " + write_value(*options.end) : ""));
  }

  std::string preview() {
    const ScratchFolder scratch(communicator);
    build(scratch.path() + "/mesh.msh");
    return hawser::preview(*system, deck(), deck().time.step);
  }

  void step_to_the_end(const Signals& signals) {
    const auto lap = run_watch.lap();
    while (!steps->finished(now())) {
      obey(signals.take());
      std::optional<StepFigures> figures = advance();
      if (!figures) continue;
      system->problem->accept();
      record->accepted(*figures);
      log->stepped(*figures, deck().time.end);
      record->write(*figures, *steps, steps->finished(now()));
    }
  }

  Summary run() {
    // What comes while the mesh is made is obeyed afterwards.
    const Signals signals(communicator);
    const ResultFolder folder(communicator, options.output, existing_results());
    set_up(folder);
    step_to_the_end(signals);
    return summarise(folder);
  }

  Summary summarise(const ResultFolder& folder) {
    Summary summary = record->summary();
    Summary& timings = summary.object("timings");
    timings.set("setup_s", setup_watch.seconds());
    const LinearSolver& linear = system->driver->linear_solver();
    double rest = newton_watch.seconds();
    for (const auto& [phase, seconds] :
         {std::pair("residual_s", system->problem->residual_seconds()),
          {"tangent_s", system->problem->tangent_seconds()},
          {"factor_s", linear.factor_seconds()},
          {"linear_solve_s", linear.solve_seconds()}}) {
      timings.set(phase, seconds);
      rest -= seconds;
    }
    timings.set("newton_rest_s", rest);
    timings.set("output_s", record->seconds());
    summary.set("wall_s", setup_watch.seconds() + run_watch.seconds());
    add_provenance(communicator, summary);
    summary.object("provenance").set("deck", run_case.text.file);
    check_expectations(deck(), summary);
    summary.write(communicator, folder.file("summary.json"));
    log->finish(*system, deck(), summary);
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
std::string Simulation::preview() { return implementation_->preview(); }

std::string Simulation::make_mesh(const std::string& file) {
  const Communicator& communicator = implementation_->communicator;
  const MeshDeck& deck = implementation_->deck().mesh;
  try {
    const std::string made = provide_mesh(communicator, implementation_->run_case, file).file;
    return describe_mesh(read_mesh(communicator, {made, deck.slits, deck.dimension()}));
  } catch (const MeshError& error) {
    throw MeshError(deck.location.text() + ": " + error.what());
  }
}
bool Simulation::has_mesh_file() const { return implementation_->deck().mesh.file.has_value(); }

std::string Simulation::resolved_deck() const {
  return resolved(implementation_->run_case.text, implementation_->registry);
}

}  // namespace hawser
