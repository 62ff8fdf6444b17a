#pragma once
// NOX's stopping test: every named block is in balance, or the iterations are used up.
#include <NOX_StatusTest_Generic.H>

#include "newton.hpp"

namespace hawser {

class BlockTest : public NOX::StatusTest::Generic {
 public:
  explicit BlockTest(Newton& newton) : newton_(newton) {}
  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver,
                                          NOX::StatusTest::CheckType type) override;
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream; }

 private:
  Newton& newton_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

}  // namespace hawser
