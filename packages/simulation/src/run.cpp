#include "hawser/simulation/run.hpp"

#include <filesystem>

#include "hawser/base/error.hpp"
#include "hawser/base/signals.hpp"
#include "hawser/output/provenance.hpp"
#include "hawser/simulation/run_deck.hpp"
#include "src/run_record.hpp"

namespace hawser {
namespace {

/// Tells a log what a stepper does.
class Teller : public Observer {
 public:
  explicit Teller(RunLog& log) : log_(log) {}

  void starting(Stepper& /*stepper*/, const StartSolve& solve) override {
    log_.solved(solve.newton);
    log_.note("start: " + solve.what +
              (solve.why.empty()
                   ? ", found in " + write_value(solve.newton.iterations) + " iterations"
                   : ": " + solve.why));
  }

  void attempted(Stepper& stepper, const Attempt& attempt) override {
    if (!attempt.newton.history.empty()) log_.solved(attempt.newton);
    if (!attempt.accepted) return log_.rejected(attempt.time, attempt.length, attempt.why);
    log_.stepped(stepper.last(), stepper.system().reports->mesh_figures(),
                 stepper.run_case().deck().time.end);
  }

 private:
  RunLog& log_;
};

/// A restarted run continues the results beside its checkpoint; elsewhere it needs --force, like
/// any run, to replace others.
ExistingResults existing_results(const Case& run_case, const std::string& output, bool force) {
  std::error_code none;
  if (run_case.checkpoint() && std::filesystem::equivalent(output, run_case.home(), none))
    return ExistingResults::go_on;
  return force ? ExistingResults::replace : ExistingResults::keep;
}

/// In the order in which things are made: what comes while the mesh is made is obeyed afterwards.
class Run {
 public:
  Run(const Case& run_case, const std::string& output, const RunOptions& options)
      : case_(run_case),
        signals_(run_case.communicator()),
        folder_(run_case.communicator(), output, existing_results(run_case, output, options.force)),
        log_(make_run_log(run_case.communicator(), options.detail, options.log_json)),
        teller_(*log_),
        stop_after_(options.stop_after) {
    const auto lap = setup_watch_.lap();
    warn_of_what_changed();
    ProvidedMesh mesh = provide_mesh(case_, folder_.file("mesh.msh"));
    if (!mesh.made.empty()) log_->note(mesh.made);
    stepper_ = std::make_unique<Stepper>(case_, std::move(mesh));
    for (const std::string& sentence : stepper_->notes())
      log_->note(sentence);
    if (!is_judged() && !case_.deck().expectations.empty())
      log_->note("the deck's expectations are for its own end, t = " +
                 write_value(*case_.end_of_deck()) + " s; this run ends before and is not judged");
    folder_.write("resolved.xml", case_.resolved_deck());
    log_->start(heading());
    stepper_->observe(teller_);
    stepper_->start();
    record_ = std::make_unique<RunRecord>(*stepper_, folder_, *log_);
    stepper_->observe(*record_);
  }

  Summary to_the_end() {
    try {
      step_to_the_end();
      return summarise();
    } catch (const OutputError& error) {
      keep_state(error);
    }
  }

 private:
  Summary summarise() {
    Summary summary = stepper_->summary();
    if (!stepper_->notes().empty()) summary.set("notes", stepper_->notes());
    add_timings(summary);
    add_provenance(case_.communicator(), summary);
    summary.object("provenance").set("deck", case_.text().file);
    const std::vector<Judgement> judgements =
        is_judged() ? judge(case_.deck().expectations, summary) : std::vector<Judgement>();
    add_judgements(judgements, summary);
    summary.write(case_.communicator(), folder_.file("summary.json"));
    log_->finish(stepper_->system().reports->closing(), judgements, summary);
    return summary;
  }

  bool is_judged() const { return !case_.end_of_deck(); }

  RunHeading heading() const {
    const System& system = stepper_->system();
    RunHeading heading{case_.deck().title,
                       folder_.path(),
                       case_.communicator().size(),
                       system.mesh.vertices.global_count,
                       system.dofs->global_count(),
                       {},
                       stepper_->time(),
                       case_.deck().time.end};
    for (const PhysicsModule& module : system.modules)
      heading.modules.push_back(module.name);
    return heading;
  }

  void warn_of_what_changed() {
    if (case_.checkpoint() == nullptr) return;
    if (!case_.damage().empty())
      log_->warn(case_.damage() + "; going on from the checkpoint before it, " +
                 case_.checkpoint()->path() +
                 ", t = " + write_value(case_.checkpoint()->header().time) + " s");
    for (const std::string& file :
         InputFiles::edited(case_.communicator(), case_.text().files->kept()))
      log_->warn(file +
                 " has changed since the run began; the run goes on with what it read then, "
                 "which is kept in the checkpoint");
  }

  void step_to_the_end() {
    const auto lap = run_watch_.lap();
    while (!stepper_->finished()) {
      obey(asked());
      try {
        step();
      } catch (const SolveError& error) {
        if (case_.deck().time.single_solve()) throw;
        throw SolveError(std::string(error.what()) + ", the last accepted state is in " +
                         record_->save_checkpoint(*stepper_));
      }
    }
  }

  void step() {
    remember_state();
    stepper_->advance();
  }

  /// Not at every one of many short steps.
  void remember_state() {
    constexpr double rarely = 1;  // s
    const bool due = !before_ || clock_.seconds() - remembered_ > rarely;
    if (!case_.communicator().any(case_.communicator().is_root() && due)) return;
    before_ = stepper_->state();
    remembered_ = clock_.seconds();
  }

  /// Results that cannot be written are no reason to lose the state that they are of: it is kept
  /// from before the step, so that the run that goes on writes them.
  [[noreturn]] void keep_state(const OutputError& error) {
    const bool newer = before_ && before_->header.step > record_->kept_step();
    try {
      if (newer) record_->save_checkpoint(*stepper_, std::move(*before_));
    } catch (const OutputError&) {  // the one that is there stays
    }
    const std::string checkpoint = record_->kept_checkpoint();
    throw OutputError(error.what() +
                      (checkpoint.empty()
                           ? "; no checkpoint can be written, either"
                           : "; when that is mended, go on with: hawser restart " + checkpoint));
  }

  /// The time is up for all ranks when it is for rank 0.
  Request asked() const {
    Request request = signals_.take();
    if (request.kind == Request::Kind::stop || !stop_after_) return request;
    const bool up = clock_.seconds() >= *stop_after_;
    if (case_.communicator().any(case_.communicator().is_root() && up))
      request = {Request::Kind::stop, "--stop-after"};
    return request;
  }

  void obey(const Request& request) {
    if (request.kind == Request::Kind::none) return;
    const std::string checkpoint = record_->save_checkpoint(*stepper_);
    const std::string time = "t = " + write_value(stepper_->time()) + " s";
    if (request.kind == Request::Kind::checkpoint)
      return log_->note(request.signal + ": checkpoint of " + time + " in " + checkpoint);
    throw Error(ExitCode::stopped, "stopped by " + request.signal + " at " + time +
                                       "; go on with: hawser restart " + checkpoint);
  }

  void add_timings(Summary& summary) const {
    const CoupledProblem& problem = *stepper_->system().problem;
    const LinearSolver& linear = stepper_->system().driver->linear_solver();
    Summary& timings = summary.object("timings");
    timings.set("setup_s", setup_watch_.seconds());
    double rest = stepper_->newton_seconds();
    for (const auto& [phase, seconds] : {std::pair("residual_s", problem.residual_seconds()),
                                         {"tangent_s", problem.tangent_seconds()},
                                         {"factor_s", linear.factor_seconds()},
                                         {"linear_solve_s", linear.solve_seconds()}}) {
      timings.set(phase, seconds);
      rest -= seconds;
    }
    timings.set("newton_rest_s", rest);
    timings.set("output_s", record_->seconds());
    summary.set("wall_s", setup_watch_.seconds() + run_watch_.seconds());
  }

  const Case& case_;
  const Signals signals_;
  const ResultFolder folder_;
  const std::unique_ptr<RunLog> log_;
  Teller teller_;
  std::unique_ptr<Stepper> stepper_;
  std::unique_ptr<RunRecord> record_;
  Stopwatch setup_watch_, run_watch_;
  std::optional<double> stop_after_;  // s
  const Clock clock_;
  std::optional<Checkpoint> before_;  // the step
  double remembered_ = 0;             // s, at which it was
};

}  // namespace

Summary run(const Case& run_case, const RunOptions& options) {
  return Run(run_case, options.output.empty() ? run_case.home() : options.output, options)
      .to_the_end();
}

}  // namespace hawser
