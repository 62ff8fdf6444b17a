#include "nox_solve.hpp"

#include <NOX_Solver_Factory.H>
#include <NOX_Solver_Generic.H>
#include <NOX_StatusTest_Combo.H>
#include <NOX_StatusTest_MaxIters.H>
#include <NOX_Utils.H>
#include <Teuchos_oblackholestream.hpp>

namespace hawser {

Teuchos::RCP<Teuchos::ParameterList> quiet_parameters() {
  auto list = Teuchos::rcp(new Teuchos::ParameterList);
  const auto nowhere = Teuchos::rcp<std::ostream>(new Teuchos::oblackholestream);
  auto& printing = list->sublist("Printing");
  printing.set("Output Information", static_cast<int>(NOX::Utils::Error));
  printing.set("Output Stream", nowhere);
  printing.set("Error Stream", nowhere);
  return list;
}

bool nox_solve(Newton& newton, const Teuchos::RCP<NewtonGroup>& group,
               const Teuchos::RCP<Teuchos::ParameterList>& parameters, int max_iterations,
               StatusTest::Function further) {
  using namespace NOX::StatusTest;
  const auto balance = [&](const NOX::Solver::Generic& solver) {
    // Newton needs the first Jacobian next anyway, and it tells what is round-off at the start.
    if (!further && solver.getNumIterations() == 0 && !newton.balanced(group->norms()))
      group->computeJacobian();
    group->estimate_errors();
    return newton.record(group->norms()) ? Converged : Unconverged;
  };
  const auto tests = Teuchos::rcp(new Combo(Combo::OR));
  tests->addStatusTest(Teuchos::rcp(new hawser::StatusTest(balance)));
  if (further) tests->addStatusTest(Teuchos::rcp(new hawser::StatusTest(further)));
  tests->addStatusTest(Teuchos::rcp(new MaxIters(max_iterations)));
  return NOX::Solver::buildSolver(group, tests, parameters)->solve() == Converged;
}

}  // namespace hawser
