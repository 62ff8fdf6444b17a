#pragma once
// One solve by one of NOX's solvers, stopped by the named blocks.
#include <NOX_StatusTest_Generic.H>
#include <Teuchos_ParameterList.hpp>

#include "newton_group.hpp"

namespace hawser {

/// A test of NOX's that asks a function.
class StatusTest : public NOX::StatusTest::Generic {
 public:
  using Status = NOX::StatusTest::StatusType;
  using Function = std::function<Status(const NOX::Solver::Generic&)>;
  explicit StatusTest(Function function) : function_(std::move(function)) {}
  Status checkStatus(const NOX::Solver::Generic& solver, NOX::StatusTest::CheckType) override {
    return status_ = function_(solver);
  }
  Status getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream; }

 private:
  Function function_;
  Status status_ = NOX::StatusTest::Unevaluated;
};

/// For a solver that prints nothing.
Teuchos::RCP<Teuchos::ParameterList> quiet_parameters();

/// Moves the group to the solution by the solver that the parameters name. False when it has not
/// got there in so many iterations, or the further test, if any, has failed. Without one the first
/// iterate is judged by its own Jacobian.
bool nox_solve(Newton& newton, const Teuchos::RCP<NewtonGroup>& group,
               const Teuchos::RCP<Teuchos::ParameterList>& parameters, int max_iterations,
               StatusTest::Function further = {});

}  // namespace hawser
