#include "backtrack.hpp"

#include <NOX_Solver_Generic.H>

#include "newton_group.hpp"

namespace hawser {

// The residual is measured row-scaled, in the norm that the linear solver reduces: an inexact
// Newton step is a descent direction for that norm, and it never mixes newtons with metres.
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
    const bool acceptable = norm <= newton_.options.allowed_growth * norm_before;
    if (acceptable || !newton_.options.line_search) {
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
