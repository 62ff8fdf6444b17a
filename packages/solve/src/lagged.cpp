#include "lagged.hpp"

#include <NOX_StatusTest_Generic.H>
#include <Tpetra_Vector.hpp>

#include <algorithm>

#include "nox_solve.hpp"

namespace hawser {
namespace {

/// Remembers the best iterate, and fails when the residual is `growth` times as large as its own.
class GrowthTest : public NOX::StatusTest::Generic {
 public:
  GrowthTest(const NewtonGroup& group, double growth, TpetraVector& best)
      : group_(group), growth_(growth), best_(best) {}
  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic&,
                                          NOX::StatusTest::CheckType) override {
    const double norm = group_.getNormF();
    if (least_ < 0 || norm < least_) {
      least_ = norm;
      best_.update(1.0, group_.x(), 0.0);
    }
    return status_ =
               norm > growth_ * least_ ? NOX::StatusTest::Failed : NOX::StatusTest::Unconverged;
  }
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream; }

 private:
  const NewtonGroup& group_;
  double growth_, least_ = -1;
  TpetraVector& best_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

}  // namespace

bool Lagged::solve(TpetraVector& x) {
  if (!newton_.options.lagged) return false;
  const bool tried = !stale_ && newton_.linear.factorizations() > 0;
  const bool converged = tried && iterate(x);
  // After a failure, and after a slow success, the next Jacobian comes with a new factor. Only
  // iterations decide, so that the same run twice takes the same way.
  const bool slow = newton_.report.iterations > newton_.options.lagged_refresh;
  if (tried && (slow || !converged)) newton_.linear.drop_factor();
  stale_ = converged && slow;  // where this fails Newton follows, and leaves a new Jacobian
  return converged;
}

bool Lagged::iterate(TpetraVector& x) {
  const auto& options = newton_.options;
  const auto group = Teuchos::rcp(new NewtonGroup(newton_, x));
  auto parameters = quiet_parameters();
  parameters->set("Nonlinear Solver", "Anderson Accelerated Fixed-Point");
  auto& anderson = parameters->sublist("Anderson Parameters");
  anderson.set("Storage Depth",
               std::min(options.anderson_depth, static_cast<int>(x.getGlobalLength())));
  anderson.sublist("Preconditioning").set("Precondition", true);
  try {
    const auto growth = Teuchos::rcp(new GrowthTest(*group, options.lagged_growth, x));
    if (nox_solve(newton_, group, parameters, options.lagged_iterations, growth)) {
      x.update(1.0, group->x(), 0.0);
      return true;
    }
  } catch (const SolveError&) {
    // Thrown on all ranks alike; Newton, which has a line search, may do better.
  }
  return false;
}

}  // namespace hawser
