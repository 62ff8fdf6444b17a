#pragma once
// NOX's test of convergence: every named block is in balance.
#include <NOX_StatusTest_Generic.H>

#include "newton_group.hpp"

namespace hawser {

class BlockTest : public NOX::StatusTest::Generic {
 public:
  /// Tests `group`, the solver's iterate, and records its norms. With `first_jacobian` the first
  /// iterate is judged by its own Jacobian, which Newton needs next.
  BlockTest(Newton& newton, NewtonGroup& group, bool first_jacobian)
      : newton_(newton), group_(group), first_jacobian_(first_jacobian) {}
  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver,
                                          NOX::StatusTest::CheckType type) override;
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream; }

 private:
  Newton& newton_;
  NewtonGroup& group_;
  bool first_jacobian_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

}  // namespace hawser
