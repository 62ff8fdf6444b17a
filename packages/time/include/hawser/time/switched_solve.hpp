#pragma once
// Newton's method where laws switch between branches (Kernel::switches).
#include "hawser/solve/nonlinear_driver.hpp"
#include "hawser/time/coupled_problem.hpp"

namespace hawser {

/// From the guess x to the solution of the laws themselves: first with the branches of the accepted
/// state held, then again and again with the law itself in the cells that ended on another branch.
/// A cell does not return to a held branch within the step, so that this ends. Where there is no
/// solution with held branches, all cells get the law itself from the start. Collective.
/// SolveError.
NonlinearReport switched_solve(CoupledProblem& problem, NonlinearDriver& driver, TpetraVector& x);

}  // namespace hawser
