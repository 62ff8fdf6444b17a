#include "nox_solve.hpp"

#include <NOX_Solver_Factory.H>
#include <NOX_Solver_Generic.H>
#include <NOX_StatusTest_Combo.H>
#include <NOX_StatusTest_MaxIters.H>
#include <NOX_Utils.H>
#include <Teuchos_oblackholestream.hpp>

#include "block_test.hpp"

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
               const Teuchos::RCP<NOX::StatusTest::Generic>& further) {
  using namespace NOX::StatusTest;
  const auto tests = Teuchos::rcp(new Combo(Combo::OR));
  tests->addStatusTest(Teuchos::rcp(new BlockTest(newton, *group, further.is_null())));
  if (!further.is_null()) tests->addStatusTest(further);
  tests->addStatusTest(Teuchos::rcp(new MaxIters(max_iterations)));
  return NOX::Solver::buildSolver(group, tests, parameters)->solve() == Converged;
}

}  // namespace hawser
