// What can go wrong in Newton's method, and what it then says.
#include <gtest/gtest.h>

#include "hawser/base/error.hpp"
#include "hawser/solve/nonlinear_driver.hpp"
#include "pointwise_problem.hpp"

namespace hawser {
namespace {

using test::PointwiseProblem;

/// The error's text, or "" when there is none. Every rank has to see the same.
std::string error_of(PointwiseProblem& problem, double guess, NonlinearOptions options = {},
                     std::function<std::string(GlobalIndex)> describe_row = {}) {
  NonlinearDriver driver(problem, {}, options);
  driver.describe_row(std::move(describe_row));
  auto x = problem.guess(guess);
  std::string text;
  try {
    driver.solve(x);
  } catch (const SolveError& error) {
    text = error.what();
    EXPECT_NEAR(x.meanValue(), guess, 1e-14) << "a failed solve has moved its guess";
  }
  EXPECT_EQ(Communicator().broadcast(text), text);
  return text;
}

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

const auto log_residual = [](double x) { return x > 0 ? std::log(x) - 1 : std::nan(""); };
const auto log_slope = [](double x) { return 1 / x; };

// From 25 the whole step and the half lead to -30 and -2.7, where there is no logarithm.
TEST(SolveErrors, InadmissibleStepIsCut) {
  std::vector<double> tried;
  const auto residual = [&](double x) {
    if (tried.empty() || tried.back() != x) tried.push_back(x);
    return log_residual(x);
  };
  PointwiseProblem problem(residual, log_slope);
  NonlinearDriver driver(problem, {}, {});
  auto x = problem.guess(25);
  EXPECT_TRUE(driver.solve(x).converged);
  EXPECT_NEAR(x.meanValue(), std::exp(1.0), 1e-7);
  const double step = -25 * log_residual(25);  // Newton's
  ASSERT_GE(tried.size(), 5U);
  for (const int i : {1, 2, 3})  // the whole, the half, the quarter; and a whole one from there
    EXPECT_NEAR(tried[static_cast<std::size_t>(i)], 25 + std::ldexp(step, 1 - i), 1e-9);
  EXPECT_NEAR(tried[4], tried[3] - tried[3] * log_residual(tried[3]), 1e-9);
}

TEST(SolveErrors, ResidualThatIsNotFiniteIsAnInadmissibleStepToo) {
  PointwiseProblem problem(log_residual, log_slope);
  problem.report_nan_as_value = true;
  EXPECT_EQ(error_of(problem, 25), "");
}

TEST(SolveErrors, WithoutLineSearchAnInadmissibleStepFails) {
  PointwiseProblem problem(log_residual, log_slope);
  NonlinearOptions options;
  options.line_search = false;
  expect_contains(error_of(problem, 25, options), "no admissible step after 0 cuts");
}

TEST(SolveErrors, NoAdmissibleStepAtAll) {
  // Wherever the step leads, it is out.
  PointwiseProblem problem([](double x) { return x == 1.0 ? 1.0 : std::nan(""); },
                           [](double) { return 1.0; });
  const auto text = error_of(problem, 1);
  expect_contains(text, "no admissible step after 8 cuts");
  expect_contains(text, "height is not admissible");
}

TEST(SolveErrors, FirstResidualNotAdmissible) {
  PointwiseProblem problem(log_residual, log_slope);
  EXPECT_EQ(error_of(problem, -1), "height is not admissible");
  problem.report_nan_as_value = true;
  const auto text = error_of(problem, -1);
  expect_contains(text, "the residual is not finite; block upper, field height");
}

TEST(SolveErrors, SingularJacobian) {
  PointwiseProblem problem([](double x) { return x * x + 1; }, [](double x) { return 2 * x; });
  expect_contains(error_of(problem, 0), "is zero, so the matrix is singular");
}

// In a uniform flow all contributions are round-off, and so is what remains: their ratio says
// nothing.
TEST(SolveErrors, ResidualBelowRoundOffOfTheJacobianIsConverged) {
  PointwiseProblem problem([](double) { return 1e-13; }, [](double) { return 1e3; });
  problem.least_magnitude = 0;
  EXPECT_EQ(error_of(problem, 1), "");
  NonlinearOptions options;
  options.round_off = 0;
  expect_contains(error_of(problem, 1, options), "no convergence in 20 iterations");
}

TEST(SolveErrors, NoConvergenceNamesTheWorstBlockAndRow) {
  PointwiseProblem problem([](double x) { return x * x + 1; }, [](double x) { return 2 * x; });
  NonlinearOptions options;
  options.max_iterations = 4;
  options.line_search = false;
  const auto text = error_of(problem, 0.3, options,
                             [](GlobalIndex row) { return "node " + std::to_string(row + 100); });
  expect_contains(text, "no convergence in 4 iterations; block upper, field height: residual ");
  expect_contains(text, " m, ");
  expect_contains(text, "of its magnitude, largest at node 1");
}

TEST(SolveErrors, DivergenceEndsTheSolve) {
  // The slope is wrong by a factor of a million and of sign: each step explodes.
  PointwiseProblem problem([](double x) { return x; }, [](double) { return -1e-6; });
  NonlinearOptions options;
  options.line_search = false;
  const auto text = error_of(problem, 1, options);
  expect_contains(text, "the residual diverges; block upper");
  options.line_search = true;
  options.max_cuts = 3;
  expect_contains(error_of(problem, 1, options), "no admissible step after 3 cuts");
}

}  // namespace
}  // namespace hawser
