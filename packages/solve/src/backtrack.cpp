#include "backtrack.hpp"

#include <NOX_Solver_Generic.H>

#include <algorithm>

namespace hawser {

// Each block against itself: none may grow unseen behind another's rows.
bool Backtrack::is_acceptable(const NewtonGroup& start, const NewtonGroup& trial) {
  const NonlinearOptions& options = newton_.options;
  const auto& before = start.norms();
  const auto& after = trial.norms();
  bool tame = true;
  for (std::size_t i = 0; i < after.size(); ++i)
    tame = tame && (after[i].ratio <= options.small_ratio ||
                    after[i].residual <= options.allowed_growth * before[i].residual);
  if (tame) return true;
  // Deuflhard, Newton Methods for Nonlinear Problems (2004), section 3.3.1: the natural level
  // function, which does not know the scales of the rows.
  const auto step = newton_.last_changes(trial.x());
  const auto left = newton_.remaining_changes(trial.x(), trial.residual());
  return *std::max_element(left.begin(), left.end()) <= *std::max_element(step.begin(), step.end());
}

bool Backtrack::compute(NOX::Abstract::Group& group, double& step,
                        const NOX::Abstract::Vector& direction,
                        const NOX::Solver::Generic& solver) {
  auto& trial = dynamic_cast<NewtonGroup&>(group);
  const auto& start = dynamic_cast<const NewtonGroup&>(solver.getPreviousSolutionGroup());
  const double norm_before = start.getNormF();
  if (first_norm_ < 0) first_norm_ = norm_before;
  const int cuts = newton_.options.line_search ? newton_.options.max_cuts : 0;
  std::string reason;
  step = 1;
  for (int cut = 0; cut <= cuts; ++cut, step /= 2) {
    trial.computeX(start, direction, step);
    try {
      trial.computeF();
    } catch (const SolveError& error) {  // thrown on all ranks alike
      reason = error.what();
      continue;
    }
    const double norm = trial.getNormF();
    if (!newton_.options.line_search || is_acceptable(start, trial)) {
      if (norm > newton_.options.divergence * first_norm_)
        throw newton_.failure("the residual diverges", trial.residual(), trial.magnitude());
      newton_.shift *= norm / norm_before;  // the pseudo-time step grows as the residual falls
      return true;
    }
    reason = newton_.failure("the residual grows", trial.residual(), trial.magnitude()).what();
  }
  throw SolveError("Newton: no admissible step after " + std::to_string(cuts) +
                   " cuts; the last trial: " + reason);
}

}  // namespace hawser
