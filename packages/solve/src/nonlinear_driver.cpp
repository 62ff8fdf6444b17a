#include "hawser/solve/nonlinear_driver.hpp"

#include <NOX_Solver_Factory.H>
#include <NOX_Solver_Generic.H>
#include <NOX_Utils.H>
#include <Teuchos_oblackholestream.hpp>
#include <Tpetra_Vector.hpp>

#include "backtrack.hpp"
#include "block_test.hpp"
#include "lagged.hpp"
#include "newton_group.hpp"

namespace hawser {
namespace {

Teuchos::RCP<Teuchos::ParameterList> nox_parameters(Newton& newton) {
  auto list = Teuchos::rcp(new Teuchos::ParameterList);
  list->set("Nonlinear Solver", "Line Search Based");
  list->sublist("Direction").set("Method", "Newton");
  auto& search = list->sublist("Line Search");
  search.set("Method", "User Defined");
  search.set("User Defined Line Search Factory",
             Teuchos::rcp<NOX::LineSearch::UserDefinedFactory>(new BacktrackFactory(newton)));
  const auto nowhere = Teuchos::rcp<std::ostream>(new Teuchos::oblackholestream);
  list->sublist("Printing").set("Output Information", static_cast<int>(NOX::Utils::Error));
  list->sublist("Printing").set("Output Stream", nowhere);
  list->sublist("Printing").set("Error Stream", nowhere);
  return list;
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
  newton.begin();
  TpetraVector start(x, Teuchos::Copy);
  if (implementation_->lagged.solve(start)) {
    x.update(1.0, start, 0.0);
    return newton.report;
  }
  newton.resume();
  const auto group = Teuchos::rcp(new NewtonGroup(newton, start));
  const auto test = Teuchos::rcp(new BlockTest(newton));
  const auto solver = NOX::Solver::buildSolver(group, test, nox_parameters(newton));
  if (solver->solve() != NOX::StatusTest::Converged) {
    throw newton.failure(
        "no convergence in " + std::to_string(newton.options.max_iterations) + " iterations",
        group->residual(), group->magnitude());
  }
  x.update(1.0, group->x(), 0.0);
  return newton.report;
}

void NonlinearDriver::on_iteration(std::function<void(const IterationReport&)> callback) {
  implementation_->newton.on_iteration = std::move(callback);
}

void NonlinearDriver::describe_row(std::function<std::string(GlobalIndex)> describe) {
  implementation_->newton.describe_row = std::move(describe);
}

void NonlinearDriver::forget() {
  implementation_->newton.forget();
  implementation_->lagged.forget();
}

LinearSolver& NonlinearDriver::linear_solver() { return implementation_->newton.linear; }

}  // namespace hawser
