#include "hawser/simulation/stepper.hpp"

#include <algorithm>
#include <filesystem>

#include "hawser/base/error.hpp"
#include "hawser/base/scratch_folder.hpp"
#include "hawser/fields/look_up.hpp"
#include "hawser/output/provenance.hpp"
#include "hawser/report/mesh_monitor.hpp"
#include "hawser/simulation/run_deck.hpp"
#include "hawser/time/state_checkpoint.hpp"
#include "hawser/time/step_control.hpp"
#include "hawser/time/switched_solve.hpp"
#include "src/continuation.hpp"
#include "src/equilibrium.hpp"
#include "src/kept_case.hpp"
#include "src/system.hpp"
#include "src/uniform_motion.hpp"

namespace hawser {
namespace {

constexpr auto what_to_try =
    "; what may lead to a steady solution: <newton pseudo-step=\"1\"/>; loads that grow with t, "
    "over more steps (a shorter <time step>); <start><equilibrium><continuation> from an easier "
    "value of a parameter, such "
    "as a greater viscosity; or time steps (another scheme) until nothing changes";

/// Where Newton's method fails in a steady solve; not where a formula is no number.
std::string advice(const std::string& why) {
  return why.rfind("Newton", 0) == 0 ? what_to_try : "";
}

}  // namespace

Stepper::Stepper(const Case& run_case)
    : case_(run_case), scratch_(std::make_unique<ScratchFolder>(run_case.communicator())) {
  mesh_ = provide_mesh(case_, scratch_->path() + "/mesh.msh");
  build();
}

namespace {

/// A step that leaves the time where it is would be made for ever.
void refuse_lost_step(const TimeDeck& deck, double begin) {
  // Where steps may grow, the first one decides.
  const double time = deck.targets ? begin : std::max(begin, deck.end);
  if (deck.steady() || time + 0.5 * deck.step > time) return;
  throw DeckError(deck.location.text() + ": a step of " + write_value(deck.step) +
                  " s is lost in the round-off of t = " + write_value(time) +
                  " s; needed is a longer one");
}

}  // namespace

Stepper::Stepper(const Case& run_case, ProvidedMesh mesh)
    : case_(run_case), mesh_(std::move(mesh)) {
  build();
}

Stepper::~Stepper() = default;

void Stepper::build() {
  system_ = build_system(case_, mesh_.file);
  mesh_.file = std::filesystem::absolute(mesh_.file).string();
  case_.text().files->keep(kept_mesh, mesh_.file, scratch_ ? "" : mesh_.file);
  const TimeDeck& time_deck = case_.deck().time;
  control_ = std::make_unique<StepControl>(
      time_deck, time_deck.steady() ? std::vector<double>() : system_->conditions->events());
  const CheckpointReader* const checkpoint = case_.checkpoint();
  refuse_lost_step(time_deck, checkpoint == nullptr ? time() : checkpoint->header().time);
  if (checkpoint == nullptr) return check_sources();
  const CheckpointHeader& header = checkpoint->header();
  system_->integrator->resume(load_history(*system_->dofs, *checkpoint));
  load_memories(system_->mesh, *checkpoint, system_->assembler->memories());
  // A step that the user changes for the rest of the run counts from here on.
  if (header.numbers.at("deck_step_s") == time_deck.step)
    control_->resume(header.numbers.at("control_step_s"),
                     static_cast<int>(header.numbers.at("control_successes")));
  system_->reports->resume(header);
  if (system_->energy) system_->energy->resume(header.part("energy."));
  number_ = header.step;
  start_iterations_ = static_cast<long long>(header.numbers.at("start_newton_iterations"));
  started_ = true;
  check_sources();
}

void Stepper::check_sources() const {
  const RunDeck& deck = case_.deck();
  const TimeDeck& time = deck.time;
  State start = system_->problem->state();
  const TimeHistory& history = system_->integrator->history();
  if (started_) start.time = history.time, start.value = history.value;
  start.step = time.steady() ? std::numeric_limits<double>::infinity() : time.step;
  const bool is_solved_for = deck.start.equilibrium && !started_;
  if (is_solved_for) drift_of_start(*system_, deck);
  system_->conditions->check_sources(start, time.step, time.end, time.steady() || is_solved_for);
}

void Stepper::start() {
  if (started_) return;
  if (case_.deck().start.equilibrium) find_equilibrium();
  started_ = true;
}

void Stepper::find_equilibrium() {
  const auto lap = newton_watch_.lap();
  const RunDeck& deck = case_.deck();
  const EquilibriumDeck& wanted = *deck.start.equilibrium;
  EquilibriumOptions options{deck.solver.linear, deck.solver.newton,
                             wanted.relaxation_step.value_or(deck.time.step),
                             drift_of_start(*system_, deck)};
  options.newton.tolerance = wanted.tolerance.value_or(options.newton.tolerance);
  options.newton.max_iterations = wanted.max_iterations;
  CoupledProblem& problem = *system_->problem;
  const auto tell = [&](const StartSolve& solve) {
    start_iterations_ += solve.newton.iterations;
    for (Observer* const observer : observers_)
      observer->starting(*this, solve);
  };
  problem.state() = wanted.continuation
                        ? continue_equilibrium(case_, mesh_.file, *system_, options, tell)
                        : hawser::find_equilibrium(*system_, options, tell);
  problem.start();
  if (system_->energy) system_->energy->start(problem.state());
}

bool Stepper::finished() const { return control_->finished(time()); }
double Stepper::time() const { return system_->integrator->history().time; }
int Stepper::steps() const { return number_; }

/// SolveError when there is no solution to be had.
NonlinearReport Stepper::solve(double length) {
  const auto lap = newton_watch_.lap();
  CoupledProblem& problem = *system_->problem;
  problem.begin_step(length);
  const auto x = problem.guess();
  NonlinearReport report = switched_solve(problem, *system_->driver, *x);
  problem.finish_step(*x);
  return report;
}

void Stepper::accept(const Attempt& attempt) {
  CoupledProblem& problem = *system_->problem;
  problem.accept();
  last_.reset(new Step{++number_, attempt.length, finished(), attempt.local_error,
                       attempt.newton.iterations, attempt.newton.linear_iterations, problem.end(),
                       problem.state(), problem.reactions(),
                       system_->energy ? &system_->energy->account() : nullptr});
  system_->reports->accepted(*last_);
}

Attempt Stepper::told(Attempt attempt) {
  attempt.time = time();
  if (!attempt.accepted) system_->reports->rejected();
  for (Observer* const observer : observers_)
    observer->attempted(*this, attempt);
  return attempt;
}

Attempt Stepper::cut(Attempt attempt) {
  attempt = told(std::move(attempt));
  if (control_->rejected(attempt.length)) return attempt;
  throw SolveError(attempt.why + "; the least step was reached" +
                   (case_.deck().time.steady() ? advice(attempt.why) : ""));
}

Attempt Stepper::advance(double longest) {
  start();
  Attempt attempt;
  attempt.length = std::min(longest, control_->next(time(), system_->integrator->history().step));
  try {
    attempt.newton = solve(attempt.length);
    refuse_tangled_mesh(*system_->dofs, system_->problem->state());
  } catch (const SolveError& error) {
    attempt.why = error.what();
    if (!case_.deck().time.single_solve()) return cut(std::move(attempt));
    told(std::move(attempt));
    throw SolveError(error.what() + advice(error.what()));
  }
  attempt.local_error = system_->integrator->local_error(system_->problem->state());
  const StepOutcome outcome{attempt.local_error, attempt.newton.iterations};
  if (control_->is_too_inaccurate(outcome) && control_->rejected(attempt.length, outcome)) {
    attempt.why = "local error " + write_value(*attempt.local_error);
    return told(std::move(attempt));
  }
  if (EnergyLedger* const ledger = system_->energy.get()) {
    EnergyAccount energy = ledger->after_step(*system_->problem);
    const double growth = case_.deck().time.energy_growth;
    if (growth > 0 && ledger->grows(energy, growth)) {
      const std::string unit = std::string("J") + system_->mesh.per_depth();
      attempt.why = "energy grows without work: " + write_value(-energy.time_dissipation) + " " +
                    unit + " since the start, of " + write_value(energy.first + energy.done) + " " +
                    unit;
      return cut(std::move(attempt));
    }
    ledger->accept(std::move(energy));
  }
  control_->accepted(attempt.length, outcome);
  attempt.accepted = true;
  accept(attempt);
  return told(std::move(attempt));
}

const std::vector<std::string>& Stepper::notes() const { return system_->notes; }

Summary Stepper::summary() const {
  Summary result;
  result.set("title", case_.deck().title);
  if (last_) system_->reports->summarise(*last_, result);
  if (case_.deck().start.equilibrium) result.set("start_newton_iterations", start_iterations_);
  return result;
}

std::vector<std::pair<std::string, double>> Stepper::quantities() const {
  std::vector<std::pair<std::string, double>> result;
  if (!last_) return result;
  for (const auto& report : system_->reports->all()) {
    const std::vector<Column> columns = report->columns();
    for (std::size_t i = 0; i < columns.size(); ++i)
      result.emplace_back(quantity_name(columns[i]), report->values()[i]);
  }
  return result;
}

std::optional<double> Stepper::quantity(const std::string& name) const {
  for (const auto& [known, value] : quantities())
    if (known == name) return value;
  return std::nullopt;
}

FieldValues Stepper::field(const std::string& name) const {
  const DofMap& dofs = *system_->dofs;
  Diagnostics diagnostics;
  const int field = find_field(dofs, {name, {}}, diagnostics);
  diagnostics.throw_if_any();
  const FieldDescription& known = dofs.fields()[static_cast<std::size_t>(field)];
  const auto dimension = static_cast<std::size_t>(dofs.mesh().dimension);
  const std::vector<double>& value = system_->integrator->history().value;
  const PointSet& corners =
      known.numbering == Numbering::sides ? dofs.mesh().split_vertices : dofs.mesh().vertices;
  FieldValues result{known.unit, known.components, dofs.mesh().dimension, {}, {}, {}};
  for (LocalIndex row = 0; row < dofs.owned(); ++row) {
    const RowInfo& info = dofs.info(row);
    if (info.field != field || info.component != 0) continue;
    // Midpoints of edges are numbered after the vertices.
    const bool on_edge = info.kind == PointKind::edge;
    result.ids.push_back(dofs.point_id(row) + (on_edge ? corners.global_count : 0));
    double x[3];
    dofs.position(row, x);
    result.positions.insert(result.positions.end(), x, x + dimension);
    for (int c = 0; c < known.components; ++c)
      result.values.push_back(value[static_cast<std::size_t>(row + c)]);
  }
  return result;
}

Checkpoint Stepper::state() const {
  CheckpointHeader header;
  header.step = number_;
  header.numbers["control_step_s"] = control_->step();
  header.numbers["control_successes"] = control_->successes();
  header.numbers["deck_step_s"] = case_.deck().time.step;
  header.numbers["start_newton_iterations"] = static_cast<double>(start_iterations_);
  system_->reports->save(header);
  if (system_->energy) header.add("energy.", system_->energy->save());
  return checkpoint_of(*system_->dofs, system_->integrator->history(),
                       system_->assembler->memories(), std::move(header));
}

void Stepper::save(const std::string& checkpoint, const std::string& previous) {
  save(state(), checkpoint, previous);
  system_->driver->forget();
}

void Stepper::save(Checkpoint state, const std::string& checkpoint,
                   const std::string& previous) const {
  Summary provenance;
  add_provenance(case_.communicator(), provenance);
  state.header.texts["provenance"] = provenance.object("provenance").json();
  std::vector<KeptFile> files;
  case_.save(state.header, files);
  write_checkpoint(case_.communicator(), checkpoint, state, files, previous);
}

}  // namespace hawser
