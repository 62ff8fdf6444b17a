#include "lagged.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <exception>

#include "nox_solve.hpp"

namespace hawser {

bool Lagged::solve(TpetraVector& x) {
  if (!newton_.options.lagged.value_or(false)) return false;
  if (stale_ || !newton_.problem.jacobian_lasts()) renew(x);
  if (!iterate(x)) {
    newton_.linear.drop_factor();
    stale_ = true;
    return false;
  }
  // To be renewed as soon as a solve costs more than the mean since the last renewal, that
  // included: waiting longer raises the mean. Only iterations count, so that the same run twice
  // takes the same way.
  const int iterations = newton_.report.iterations;
  stale_ = solves_ > 0 && iterations * solves_ > spent_;
  spent_ += iterations;
  ++solves_;
  return true;
}

void Lagged::renew(const TpetraVector& x) {
  newton_.linear.drop_factor();
  newton_.compute_jacobian(x);
  if (newton_.linear.prepare()) ++newton_.report.factorizations;
  stale_ = false;
  spent_ = newton_.options.renewal_cost;
  solves_ = 0;
}

bool Lagged::iterate(TpetraVector& x) {
  const auto& options = newton_.options;
  const auto group = Teuchos::rcp(new NewtonGroup(newton_, x));
  auto parameters = quiet_parameters();
  parameters->set("Nonlinear Solver", "Anderson Accelerated Fixed-Point");
  auto& anderson = parameters->sublist("Anderson Parameters");
  anderson.set("Storage Depth",
               std::min(options.anderson_depth, static_cast<int>(x.getGlobalLength())));
  anderson.sublist("Preconditioning").set("Precondition", true);
  double least = -1;
  const auto remember_the_best = [&](const NOX::Solver::Generic&) {
    const double norm = group->getNormF();
    if (least < 0 || norm < least) {
      least = norm;
      x.update(1.0, group->x(), 0.0);
    }
    return norm > options.lagged_growth * least ? NOX::StatusTest::Failed
                                                : NOX::StatusTest::Unconverged;
  };
  try {
    if (nox_solve(newton_, group, parameters, options.lagged_iterations, remember_the_best)) {
      x.update(1.0, group->x(), 0.0);
      return true;
    }
  } catch (const SolveError&) {
    // Thrown on all ranks alike; Newton, which has a line search, may do better.
  } catch (const std::exception&) {
    // NOX's Anderson finds that two updates are parallel, which round-off can make them.
  }
  return false;
}

}  // namespace hawser
