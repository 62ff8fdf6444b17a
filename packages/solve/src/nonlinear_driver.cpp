#include "hawser/solve/nonlinear_driver.hpp"

#include <NOX_LineSearch_UserDefinedFactoryT.H>
#include <Tpetra_Vector.hpp>

#include <algorithm>

#include "backtrack.hpp"
#include "lagged.hpp"
#include "levels.hpp"
#include "nox_solve.hpp"

namespace hawser {
namespace {

Teuchos::RCP<Teuchos::ParameterList> newton_parameters(Newton& newton) {
  auto list = quiet_parameters();
  list->set("Nonlinear Solver", "Line Search Based");
  list->sublist("Direction").set("Method", "Newton");
  auto& direction = list->sublist("Direction").sublist("Newton");
  const double tightest = newton.linear.options().tolerance;
  direction.sublist("Linear Solver").set("Tolerance", tightest);
  if (newton.options.forcing) {  // by the group's getNormF()
    const double loosest = std::max(tightest, newton.options.forcing_max);
    direction.set("Forcing Term Method", "Type 2");
    direction.set("Forcing Term Alpha", 2.0);
    direction.set("Forcing Term Initial Tolerance", loosest);
    direction.set("Forcing Term Maximum Tolerance", loosest);
    direction.set("Forcing Term Minimum Tolerance", tightest);
  }
  auto& search = list->sublist("Line Search");
  search.set("Method", "User Defined");
  search.set("Newton", &newton);
  search.set("User Defined Line Search Factory",
             Teuchos::rcp<NOX::LineSearch::UserDefinedFactory>(
                 new NOX::LineSearch::UserDefinedFactoryT<Backtrack>));
  return list;
}

/// The guess with the levels of its fields in place.
Teuchos::RCP<NewtonGroup> first_iterate(Newton& newton, const TpetraVector& guess) {
  auto group = Teuchos::rcp(new NewtonGroup(newton, guess));
  group->computeF();
  if (newton.balanced(group->norms())) return group;
  group->computeJacobian();  // Newton needs it next anyway, and it tells what is round-off
  TpetraVector levelled(guess, Teuchos::Copy);
  if (!newton.balanced(group->norms()) &&
      level_fields(newton.problem.system(), group->residual(), levelled))
    group = Teuchos::rcp(new NewtonGroup(newton, levelled));
  return group;
}

}  // namespace

struct NonlinearDriver::Implementation {
  Newton newton;
  Lagged lagged{newton};
};

NonlinearDriver::NonlinearDriver(NonlinearProblem& problem, LinearOptions linear,
                                 NonlinearOptions options)
    : implementation_(new Implementation{{problem, linear, options}}) {}
NonlinearDriver::~NonlinearDriver() = default;

NonlinearReport NonlinearDriver::solve(TpetraVector& x) {
  auto& newton = implementation_->newton;
  newton.report = {};
  TpetraVector start(x, Teuchos::Copy);
  if (!implementation_->lagged.solve(start)) {
    const int most = newton.options.max_iterations;
    newton.shift = newton.options.pseudo_step > 0 ? 1 / newton.options.pseudo_step : 0;
    const auto group = first_iterate(newton, start);
    if (!nox_solve(newton, group, newton_parameters(newton), most))
      throw newton.failure("no convergence in " + std::to_string(most) + " iterations",
                           group->residual(), group->magnitude());
    start.update(1.0, group->x(), 0.0);
  }
  x.update(1.0, start, 0.0);
  newton.report.notes = newton.linear.take_notes();
  return newton.report;
}

void NonlinearDriver::describe_row(std::function<std::string(GlobalIndex)> describe) {
  implementation_->newton.describe_row = std::move(describe);
}

void NonlinearDriver::forget() {
  implementation_->newton.forget();
  implementation_->lagged.forget();
}

const LinearSolver& NonlinearDriver::linear_solver() const {
  return implementation_->newton.linear;
}

}  // namespace hawser
