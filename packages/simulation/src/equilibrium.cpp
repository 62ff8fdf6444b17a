#include "src/equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/time/switched_solve.hpp"

namespace hawser {
namespace {

constexpr int most_steps = 200;                             // of the relaxation
constexpr double least_share = 1e-6, greatest_share = 1e9;  // of its first step
constexpr double rough_tolerance = 1e-4;                    // its steps are guesses only
constexpr int quick = 5, slow = 10;   // iterations: the next step is four times, twice as long
constexpr double settled = 0.05;      // change in a step: Newton's method may try again ...
constexpr double more_settled = 0.2;  // ... and next time at this share of it, ...
constexpr int patience = 10;          // ... or after so many steps
constexpr double lost = 1e3;  // sizes of the mesh: a structure that far away is held by nothing

TimeScheme scheme_of(TimeScheme::Method method) {
  TimeScheme scheme;
  scheme.method = method;
  return scheme;
}

/// The largest displacement over the size of the mesh. Where nothing holds a structure its weight
/// is small against the tensions of an absurd shape, and a residual relative to them says nothing.
double farthest(const System& system, const State& state) {
  const DofMap& dofs = *system.dofs;
  const Communicator& all = dofs.mesh().communicator;
  const int displacement = dofs.find(field_name::displacement);
  double largest = 0, low = 0, high = 0;
  for (LocalIndex row = 0; row < dofs.owned(); ++row) {
    const RowInfo& info = dofs.info(row);
    if (info.field != displacement) continue;
    double x[3];
    dofs.position(row, x);
    low = std::min(low, x[info.component]);
    high = std::max(high, x[info.component]);
    largest = std::max(largest, std::abs(state.value[static_cast<std::size_t>(row)]));
  }
  const double size = all.max(high) + all.max(-low);
  return size > 0 ? all.max(largest) / size : 0;
}

/// Solves one after the other with one scheme, each from a given state.
class Solves {
 public:
  Solves(System& system, TimeScheme::Method method, const LinearOptions& linear,
         const NonlinearOptions& newton)
      : integrator_(*system.assembler, system.table.rate_rules, scheme_of(method)),
        problem_(*system.assembler, integrator_, *system.conditions),
        driver_(problem_, linear, newton) {
    driver_.describe_row(
        [dofs = system.dofs.get()](GlobalIndex row) { return describe_row(*dofs, row); });
  }

  /// `state` becomes what a step of that length makes of it. When there is no such state it stays
  /// as it is, and why() says what is in the way.
  bool solve(State& state, double step, StartSolve& done) {
    try {
      problem_.state() = state;
      problem_.start();
      problem_.begin_step(step);
      const auto x = problem_.guess();
      done.newton = switched_solve(problem_, driver_, *x);
      problem_.finish_step(*x);
      problem_.accept();
    } catch (const SolveError& error) {
      done.why = error.what();
      return false;
    }
    state = problem_.end();
    return true;
  }

 private:
  TimeIntegrator integrator_;
  CoupledProblem problem_;
  NonlinearDriver driver_;
};

class Search {
 public:
  Search(System& system, const EquilibriumOptions& options,
         const std::function<void(const StartSolve&)>& tell)
      : system_(system),
        tell_(tell),
        relaxes_(options.relaxes),
        first_step_(options.relaxation_step),
        state_(system.problem->state()),
        time_(state_.time),
        drift_(options.drift),
        steady_(system, TimeScheme::Method::steady, options.linear, options.newton),
        relaxing_(system, TimeScheme::Method::bdf2, options.linear, relaxed(options.newton)) {}

  State find() {
    state_.drift = drift_;
    if (!settle()) {
      if (!relaxes_) throw SolveError(why_);
      relax();
    }
    std::fill(state_.rate.begin(), state_.rate.end(), 0.0);
    for (const auto& pair : system_.assembler->kinematic_pairs())
      state_.rate[static_cast<std::size_t>(pair.displacement)] = drift_of(pair);
    state_.drift = {};
    state_.time = time_;
    return std::move(state_);
  }

 private:
  static NonlinearOptions relaxed(NonlinearOptions options) {
    options.tolerance = std::max(options.tolerance, rough_tolerance);
    options.pseudo_step = 0;
    return options;
  }

  bool settle() {
    StartSolve done{"steady state", {}, {}};
    state_.time = time_;
    const bool found = steady_.solve(state_, 0, done);
    tell_(done);
    if (!found) why_ = done.why;
    if (!found || farthest(system_, state_) < lost) return found;
    throw SolveError(
        "no equilibrium: what the statics find is a thousand times further away than the "
        "mesh is large, so that some structure is held by nothing");
  }

  void relax() {
    double step = first_step_, limit = settled;
    int since = 0;
    for (int i = 0; i < most_steps && step >= least_share * first_step_ &&
                    step <= greatest_share * first_step_;
         ++i) {
      StartSolve done{"relaxation over " + write_value(step) + " s", {}, {}};
      const std::vector<double> before = state_.value;
      const bool found = relaxed_by(step, done);
      tell_(done);
      if (!found) {
        why_ = done.why;
        step /= 4;
        continue;
      }
      ++since;
      if (done.newton.iterations <= slow) step *= done.newton.iterations <= quick ? 4 : 2;
      if (relative_change(before) > limit && since < patience) continue;
      if (settle()) return;
      limit *= more_settled;
      since = 0;
    }
    throw SolveError("no equilibrium was found to start from: " + why_ +
                     "; what may lead to one: initial values that are nearer, another "
                     "relaxation-step of <equilibrium>, <newton pseudo-step=\"1\"/>, or "
                     "<continuation> from an easier value of a parameter");
  }

  double drift_of(const Assembler::KinematicPair& pair) const {
    return drift_[static_cast<std::size_t>(system_.dofs->info(pair.velocity).component)];
  }

  /// With the conditions of the start: the step ends there. Seen from what drifts, structures begin
  /// at rest.
  bool relaxed_by(double step, StartSolve& done) {
    State moved = state_;
    for (const auto& pair : system_.assembler->kinematic_pairs()) {
      moved.value[static_cast<std::size_t>(pair.velocity)] = drift_of(pair);
      moved.value[static_cast<std::size_t>(pair.displacement)] -= step * drift_of(pair);
    }
    std::fill(moved.rate.begin(), moved.rate.end(), 0.0);
    moved.time = time_ - step;
    if (!relaxing_.solve(moved, step, done)) return false;
    state_ = std::move(moved);
    return true;
  }

  /// Of fields that have inertia or a place, the largest of all, relative to the field; the
  /// velocity of a structure is none of them, it begins each step at rest. Collective.
  double relative_change(const std::vector<double>& before) const {
    const DofMap& dofs = *system_.dofs;
    std::vector<char> counts(static_cast<std::size_t>(dofs.rows()), 1);
    for (const auto& pair : system_.assembler->kinematic_pairs())
      counts[static_cast<std::size_t>(pair.velocity)] = 0;
    std::vector<double> changes(dofs.fields().size(), 0), sizes(dofs.fields().size(), 0);
    for (LocalIndex owned = 0; owned < dofs.owned(); ++owned) {
      const auto row = static_cast<std::size_t>(owned);
      const auto field = static_cast<std::size_t>(dofs.info(owned).field);
      if (counts[row] == 0 || system_.table.rate_rules[field] == RateRule::none) continue;
      changes[field] += std::pow(state_.value[row] - before[row], 2);
      sizes[field] += std::pow(state_.value[row], 2);
    }
    const Communicator& all = dofs.mesh().communicator;
    double worst = 0;
    for (std::size_t field = 0; field < sizes.size(); ++field)
      if (const double size = all.sum(sizes[field]); size > 0)
        worst = std::max(worst, std::sqrt(all.sum(changes[field]) / size));
    return worst;
  }

  System& system_;
  const std::function<void(const StartSolve&)>& tell_;
  bool relaxes_;
  double first_step_;  // s, of the relaxation
  State state_;
  double time_;                  // s, of the start
  std::array<double, 3> drift_;  // m/s
  Solves steady_, relaxing_;
  std::string why_;  // the last solve found nothing
};

}  // namespace

State find_equilibrium(System& system, const EquilibriumOptions& options,
                       const std::function<void(const StartSolve&)>& tell) {
  return Search(system, options, tell).find();
}

}  // namespace hawser
