#include "block_test.hpp"

#include <NOX_Solver_Generic.H>

#include "newton_group.hpp"

namespace hawser {

NOX::StatusTest::StatusType BlockTest::checkStatus(const NOX::Solver::Generic& solver,
                                                   NOX::StatusTest::CheckType) {
  const auto& group = dynamic_cast<const NewtonGroup&>(solver.getSolutionGroup());
  const int iteration = solver.getNumIterations();
  if (newton_.judge(iteration, group.x(), group.stamp(), group.residual(), group.magnitude()))
    status_ = NOX::StatusTest::Converged;
  else if (iteration >= newton_.options.max_iterations)
    status_ = NOX::StatusTest::Failed;
  else
    status_ = NOX::StatusTest::Unconverged;
  return status_;
}

}  // namespace hawser
