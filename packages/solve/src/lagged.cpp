#include "lagged.hpp"

#include <Tpetra_Vector.hpp>

#include "anderson.hpp"

namespace hawser {

bool Lagged::solve(TpetraVector& x) {
  if (!newton_.options.lagged) return false;
  const bool tried = !stale_ && newton_.linear.factorizations() > 0;
  const bool converged = tried && iterate(x);
  // After a failure, and after a slow success, the next Jacobian comes with a new factor. Only
  // iterations decide, so that the same run twice takes the same way.
  const bool slow = newton_.report.iterations > newton_.options.lagged_refresh;
  if (tried && (slow || !converged)) newton_.linear.drop_factor();
  stale_ = converged && slow;  // where this fails Newton follows, and leaves a new Jacobian
  return converged;
}

bool Lagged::iterate(TpetraVector& x) {
  const auto& options = newton_.options;
  TpetraVector f(x.getMap()), magnitude(x.getMap()), scaled(x.getMap()), update(x.getMap());
  TpetraVector best(x, Teuchos::Copy);
  double least = -1;
  Anderson anderson(options.anderson_depth);
  try {
    newton_.compute_residual(x, f, magnitude);
    for (int iteration = 0;; ++iteration) {
      if (newton_.judge(iteration, x, 0, f, magnitude)) return true;
      const double norm = newton_.linear.scaled_norm(f);
      if (least < 0 || norm < least) {
        least = norm;
        best.update(1.0, x, 0.0);
      }
      if (iteration == options.lagged_iterations || norm > options.lagged_growth * least) break;
      newton_.solve_linear(f, update, options.lagged_tolerance);
      if (newton_.last_linear().factored)
        anderson.forget();  // the measure of residuals has changed
      newton_.linear.scale(f, scaled);
      anderson.advance(scaled, update, x);
      newton_.compute_residual(x, f, magnitude);
      newton_.accept_step(1.0, norm, newton_.linear.scaled_norm(f));
    }
  } catch (const SolveError&) {
    // Thrown on all ranks alike; Newton, which has a line search, may do better.
  }
  x.update(1.0, best, 0.0);
  return false;
}

}  // namespace hawser
