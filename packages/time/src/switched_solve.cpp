#include "hawser/time/switched_solve.hpp"

#include <Tpetra_Vector.hpp>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

/// `later` went on from where `report` ended: its start is that one's last iterate.
void append(NonlinearReport& report, const NonlinearReport& later) {
  report.converged = later.converged;
  report.iterations += later.iterations;
  report.jacobians += later.jacobians;
  report.linear_iterations += later.linear_iterations;
  report.factorizations += later.factorizations;
  report.notes.insert(report.notes.end(), later.notes.begin(), later.notes.end());
  report.history.insert(report.history.end(), later.history.begin(), later.history.end());
  report.ratios.insert(report.ratios.end(), later.ratios.begin(), later.ratios.end());
  report.criteria.insert(report.criteria.end(), later.criteria.begin(), later.criteria.end());
}

}  // namespace

NonlinearReport switched_solve(CoupledProblem& problem, NonlinearDriver& driver, TpetraVector& x) {
  const auto guess = problem.guess();
  NonlinearReport report;
  try {
    append(report, driver.solve(x));
    while (!problem.on_held_branches(x))
      append(report, driver.solve(x));
  } catch (const SolveError&) {
    if (!problem.release_switches()) throw;
    x.update(1, *guess, 0);
    append(report, driver.solve(x));
  }
  return report;
}

}  // namespace hawser
