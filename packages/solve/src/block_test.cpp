#include "block_test.hpp"

#include <NOX_Solver_Generic.H>

namespace hawser {

NOX::StatusTest::StatusType BlockTest::checkStatus(const NOX::Solver::Generic& solver,
                                                   NOX::StatusTest::CheckType) {
  // Newton needs the first Jacobian next anyway, and it tells what is round-off at the start.
  if (first_jacobian_ && solver.getNumIterations() == 0 && !newton_.balanced(group_.norms()))
    group_.computeJacobian();
  status_ =
      newton_.record(group_.norms()) ? NOX::StatusTest::Converged : NOX::StatusTest::Unconverged;
  return status_;
}

}  // namespace hawser
