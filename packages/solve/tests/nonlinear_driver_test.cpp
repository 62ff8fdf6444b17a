#include "hawser/solve/nonlinear_driver.hpp"

#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <cmath>

#include "hawser/base/error.hpp"
#include "pointwise_problem.hpp"
#include "reaction_transport.hpp"

namespace hawser {
namespace {

using test::ReactionTransport;
using Method = LinearOptions::Method;

struct Outcome {
  NonlinearReport report;
  TpetraVector x;
  double error = 0;  ///< against the manufactured solution, relative
};

Outcome solve(LinearOptions linear, NonlinearOptions options = {}) {
  ReactionTransport problem(24);
  NonlinearDriver driver(problem, linear, options);
  TpetraVector x(problem.system().rows);
  auto report = driver.solve(x);
  auto difference = problem.exact();
  const double size = difference.norm2();
  difference.update(1.0, x, -1.0);
  return {std::move(report), x, difference.norm2() / size};
}

TEST(NonlinearDriver, FindsTheManufacturedSolutionWithBothBackends) {
  LinearOptions linear;
  linear.tolerance = 1e-10;
  NonlinearOptions options;
  options.tolerance = 1e-12;
  const auto gmres = solve(linear, options);
  linear.method = Method::mumps;
  const auto mumps = solve(linear, options);
  EXPECT_LT(gmres.error, 1e-9);
  EXPECT_LT(mumps.error, 1e-9);
  EXPECT_EQ(gmres.report.iterations, mumps.report.iterations);
  EXPECT_EQ(gmres.report.iterations, 4);  // on any number of ranks
  EXPECT_EQ(gmres.report.factorizations, gmres.report.iterations);
  TpetraVector difference(gmres.x, Teuchos::Copy);
  difference.update(1.0, mumps.x, -1.0);
  EXPECT_LT(difference.norm2(), 1e-9 * gmres.x.norm2());
}

TEST(NonlinearDriver, ConvergesQuadratically) {
  LinearOptions linear;
  linear.method = Method::mumps;
  linear.tolerance = 1e-12;
  NonlinearOptions options;
  options.tolerance = 1e-11;
  const auto& ratios = solve(linear, options).report.ratios;
  ASSERT_GE(ratios.size(), 4U);
  int seen = 0;
  for (std::size_t i = 1; i + 1 < ratios.size(); ++i) {
    if (ratios[i - 1] > 1e-2 || ratios[i + 1] < 1e-13) continue;  // not near yet; round-off
    const double order = std::log(ratios[i + 1] / ratios[i]) / std::log(ratios[i] / ratios[i - 1]);
    EXPECT_GT(order, 1.7) << ratios[i] << " -> " << ratios[i + 1];
    ++seen;
  }
  EXPECT_GE(seen, 1);
}

TEST(NonlinearDriver, TheLargestBlockDecides) {
  const auto outcome = solve({});
  ASSERT_TRUE(outcome.report.converged);
  for (const auto& norm : outcome.report.history.back())
    EXPECT_LE(norm.ratio, 1e-8);
  const auto& start = outcome.report.history.front();
  ASSERT_EQ(start.size(), 2U);
  for (const auto& norm : start)
    EXPECT_DOUBLE_EQ(norm.ratio, norm.residual / norm.magnitude);
  EXPECT_EQ(start[0].block, "heat");
  EXPECT_EQ(start[1].unit, "mol/s");
  EXPECT_GT(start[0].magnitude, 1e4 * start[1].magnitude);  // the units lie far apart
}

TEST(NonlinearDriver, ReportsEveryIteration) {
  const auto report = solve({}).report;
  ASSERT_EQ(report.history.size(), static_cast<std::size_t>(report.iterations) + 1);
  ASSERT_EQ(report.ratios.size(), report.history.size());
  for (std::size_t i = 0; i < report.ratios.size(); ++i)
    EXPECT_EQ(report.ratios[i],
              std::max(report.history[i].at(0).ratio, report.history[i].at(1).ratio));
  EXPECT_EQ(report.jacobians, report.iterations);
  EXPECT_GE(report.linear_iterations, report.iterations);
}

TEST(NonlinearDriver, KeptFactorSpansNewtonIterationsAndSolves) {
  LinearOptions linear;
  linear.keep_factor = true;
  ReactionTransport problem(24);
  NonlinearDriver driver(problem, linear, {});
  int factorizations = 0;
  for (const double speed : {20.0, 20.5, 21.0}) {
    problem.speed = speed;
    TpetraVector x(problem.system().rows);
    const auto report = driver.solve(x);
    EXPECT_LE(report.iterations, 5);
    factorizations += report.factorizations;
  }
  EXPECT_EQ(factorizations, 1);
  EXPECT_EQ(driver.linear_solver().factorizations(), 1);
}

// As in a run of time steps: the problem moves on a little from solve to solve.
TEST(NonlinearDriver, LaggedJacobianServesManySolves) {
  for (const auto method : {Method::gmres, Method::mumps}) {
    LinearOptions linear;
    linear.method = method;
    linear.keep_factor = true;
    NonlinearOptions options;
    options.lagged = true;
    ReactionTransport problem(24);
    NonlinearDriver driver(problem, linear, options);
    TpetraVector x(problem.system().rows);
    int jacobians = 0;
    for (int step = 0; step < 10; ++step) {
      problem.speed = 20 + step;
      x.putScalar(0.1);
      jacobians += driver.solve(x).jacobians;
      auto difference = problem.exact();
      difference.update(1.0, x, -1.0);
      EXPECT_LT(difference.norm2(), 1e-5 * x.norm2());
    }
    EXPECT_LE(jacobians, 6);  // Newton would take 3 each time
    driver.forget();
    x.putScalar(0.1);
    EXPECT_GE(driver.solve(x).jacobians, 1);
    problem.speed = -4000;
    x.putScalar(0.1);
    const auto report = driver.solve(x);
    EXPECT_TRUE(report.converged);
    EXPECT_GE(report.jacobians, 1);  // lagging has failed, Newton has not
  }
}

TEST(NonlinearDriver, ForcingSavesLinearIterations) {
  NonlinearOptions options;
  const auto fixed = solve({}, options);
  options.forcing = true;
  const auto forced = solve({}, options);
  EXPECT_LT(forced.report.linear_iterations, fixed.report.linear_iterations);
  EXPECT_LE(forced.report.ratios.back(), options.tolerance);
}

// Newton's method goes round between 0 and 1; where x' = -f leads, at -1.77, it would be at home.
TEST(NonlinearDriver, PseudoTransientContinuationLeavesACycle) {
  test::PointwiseProblem problem([](double x) { return x * x * x - 2 * x + 2; },
                                 [](double x) { return 3 * x * x - 2; });
  NonlinearOptions options;
  auto x = problem.guess(0);
  EXPECT_THROW(NonlinearDriver(problem, {}, options).solve(x), SolveError);
  options.pseudo_step = 0.5;
  const auto& ratios = NonlinearDriver(problem, {}, options).solve(x).ratios;
  EXPECT_NEAR(x.meanValue(), -1.7692923542386314, 1e-9);
  ASSERT_GE(ratios.size(), 3U);  // Newton's own speed at the end
  EXPECT_LT(ratios.back(), 1e-2 * ratios[ratios.size() - 2]);
}

// Where much cancels a small residual says little: x is 8 % off when it first passes.
TEST(NonlinearDriver, AsksHowFarTheUnknownsAreOff) {
  test::PointwiseProblem problem([](double x) { return x * x - 4; },
                                 [](double x) { return 2 * x; });
  problem.least_magnitude = 1e8;
  NonlinearOptions options;
  options.update_tolerance = 0;
  auto x = problem.guess(3);
  EXPECT_EQ(NonlinearDriver(problem, {}, options).solve(x).iterations, 1);
  EXPECT_NEAR(x.meanValue(), 13. / 6, 1e-5);
  options.update_tolerance = 1e-3;
  x = problem.guess(3);
  const auto report = NonlinearDriver(problem, {}, options).solve(x);
  EXPECT_EQ(report.iterations, 3);
  EXPECT_NEAR(x.meanValue(), 2, 1e-3);
  const Criterion& decided = report.criteria.back();
  EXPECT_EQ(decided.test, "update");
  EXPECT_LE(decided.value, decided.tolerance);
  // The estimate after the first iteration: f / J there is 0.116 of 2.17, as x was in truth off.
  EXPECT_NEAR(report.criteria[1].value, (13. / 6 * 13. / 6 - 4) / 6 / (13. / 6), 1e-4);
}

TEST(NonlinearDriver, StartsFromTheSolutionWithoutAStep) {
  ReactionTransport problem(12);
  NonlinearDriver driver(problem, {}, {});
  auto x = problem.exact();
  const auto report = driver.solve(x);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_EQ(report.factorizations, 0);
}

TEST(NonlinearDriver, SameRunTwiceIsTheSameToTheLastBit) {
  for (const auto method : {Method::gmres, Method::mumps}) {
    LinearOptions linear;
    linear.method = method;
    linear.keep_factor = true;
    const auto first = solve(linear);
    const auto second = solve(linear);
    const auto a = first.x.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto b = second.x.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t row = 0; row < a.extent(0); ++row)
      ASSERT_EQ(a(row, 0), b(row, 0));
    EXPECT_EQ(first.report.ratios, second.report.ratios);
  }
}

}  // namespace
}  // namespace hawser
