#include "hawser/solve/linear_solver.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hawser/base/error.hpp"
#include "hawser/base/stopwatch.hpp"
#include "reaction_transport.hpp"

namespace hawser {
namespace {

using test::ReactionTransport;
using Method = LinearOptions::Method;

class LinearSolverTest : public testing::Test {
 protected:
  LinearSolverTest() : rhs(problem.system().rows), x(rhs.getMap()) {
    set_speed(20);
    for (std::size_t row = 0; row < rhs.getLocalLength(); ++row)  // in the rows' own units
      rhs.replaceLocalValue(static_cast<LocalIndex>(row), row % 2 == 0 ? 1e3 : 1e-3);
  }

  void set_speed(double speed) {
    problem.speed = speed;
    problem.jacobian(problem.exact());
  }

  /// Worst over the two fields of |rhs - A x| / |rhs|: a solver that scales badly fails in one.
  double error() const {
    TpetraVector remainder(rhs.getMap());
    problem_matrix().apply(x, remainder);
    remainder.update(1.0, rhs, -1.0);
    const auto r = remainder.getLocalViewHost(Tpetra::Access::ReadOnly);
    double worst = 0;
    for (std::size_t row = 0; row < rhs.getLocalLength(); ++row)
      worst = std::max(worst, std::abs(r(row, 0)) / (row % 2 == 0 ? 1e3 : 1e-3));
    return Communicator().max(worst);
  }

  const TpetraMatrix& problem_matrix() const { return *matrix; }

  ReactionTransport problem{24};
  Teuchos::RCP<TpetraMatrix> matrix = problem.system().matrix;
  TpetraVector rhs, x;
};

// The matrix' rows are of different units, the shift is of the scaled rows' order, one.
TEST_F(LinearSolverTest, AShiftDampsAllRowsAlike) {
  LinearSolver solver(problem.system(), {});
  solver.solve(rhs, x);
  const double size = x.norm2();
  solver.matrix_changed(1e6);
  TpetraVector damped(x.getMap()), scaled(x.getMap());
  solver.solve(rhs, damped);
  EXPECT_LT(damped.norm2(), 1e-3 * size);
  solver.scale(rhs, scaled);
  scaled.update(-1e6, damped, 1.0);
  EXPECT_LT(scaled.norm2(), 1e-4 * 1e6 * damped.norm2());
}

TEST_F(LinearSolverTest, WatchesTellFactorAndSolveApart) {
  LinearOptions options;
  options.keep_factor = true;
  LinearSolver solver(problem.system(), options);
  Stopwatch all;
  {
    const auto lap = all.lap();
    solver.solve(rhs, x);
  }
  const double factor = solver.factor_seconds(), solve = solver.solve_seconds();
  EXPECT_GT(factor, 0);
  EXPECT_GT(solve, 0);
  EXPECT_LE(factor + solve, all.seconds());
  solver.solve(rhs, x);  // with the kept factor
  EXPECT_EQ(solver.factor_seconds(), factor);
  EXPECT_GT(solver.solve_seconds(), solve);
}

TEST_F(LinearSolverTest, GmresMeetsItsToleranceInBothUnits) {
  LinearSolver solver(problem.system(), {});
  const auto report = solver.solve(rhs, x, 1e-8);
  EXPECT_TRUE(report.factored);
  EXPECT_GT(report.iterations, 3);
  EXPECT_LT(report.iterations, 40);
  EXPECT_LE(report.reached, 2e-8);
  EXPECT_LT(error(), 1e-6);
}

TEST_F(LinearSolverTest, FreshMumpsNeedsOneIteration) {
  LinearOptions options;
  options.method = Method::mumps;
  for (const bool repeatable : {true, false}) {  // on rank 0, on all
    options.repeatable = repeatable;
    LinearSolver solver(problem.system(), options);
    const auto report = solver.solve(rhs, x, 1e-10);
    EXPECT_EQ(report.iterations, 1);
    EXPECT_LT(error(), 1e-8);
  }
}

TEST_F(LinearSolverTest, BackendsAgree) {
  LinearOptions options;
  LinearSolver gmres(problem.system(), options);
  gmres.solve(rhs, x, 1e-12);
  options.method = Method::mumps;
  LinearSolver mumps(problem.system(), options);
  TpetraVector y(x.getMap());
  mumps.solve(rhs, y, 1e-12);
  y.update(1.0, x, -1.0);
  EXPECT_LT(y.norm2(), 1e-9 * x.norm2());
}

// Ifpack2 keeps stale overlap values unless it is made to look again: seen on more than one rank.
TEST_F(LinearSolverTest, NewMatrixValuesReachTheFactor) {
  for (const auto method : {Method::gmres, Method::mumps, Method::blocks}) {
    LinearOptions options;
    options.method = method;
    set_speed(20);
    LinearSolver used(problem.system(), options);
    used.solve(rhs, x);
    set_speed(-4000);
    used.matrix_changed();
    const auto again = used.solve(rhs, x, 1e-8);
    EXPECT_TRUE(again.factored);
    EXPECT_LT(error(), 1e-6);
    LinearSolver fresh(problem.system(), options);
    EXPECT_EQ(again.iterations, fresh.solve(rhs, x, 1e-8).iterations);
  }
}

TEST_F(LinearSolverTest, KeptFactorIsRefreshedByIterationCount) {
  for (const auto method : {Method::gmres, Method::mumps, Method::blocks}) {
    LinearOptions options;
    options.method = method;
    options.keep_factor = true;
    set_speed(20);
    LinearSolver solver(problem.system(), options);
    const auto solve_at = [&](double speed) {
      set_speed(speed);
      solver.matrix_changed();
      const auto report = solver.solve(rhs, x);
      EXPECT_LT(error(), 1e-3);
      return report;
    };
    EXPECT_TRUE(solve_at(20).factored);
    EXPECT_FALSE(solve_at(20.1).factored);  // hardly another matrix: the factor still pays
    EXPECT_FALSE(solve_at(20.2).factored);
    const auto stale = solve_at(400);  // pays no longer, but still serves this solve
    EXPECT_FALSE(stale.factored);
    EXPECT_TRUE(solve_at(400).factored);
    EXPECT_FALSE(solve_at(400).factored);
    solver.drop_factor();
    EXPECT_TRUE(solve_at(400).factored);
    EXPECT_EQ(solver.factorizations(), 3);
  }
}

TEST_F(LinearSolverTest, FailingKeptFactorIsRefreshedWithinTheSolve) {
  LinearOptions options;
  options.keep_factor = true;
  options.max_iterations = 30;
  LinearSolver solver(problem.system(), options);
  solver.solve(rhs, x);
  set_speed(-4000);  // the wind turns
  solver.matrix_changed();
  const auto report = solver.solve(rhs, x);
  EXPECT_TRUE(report.factored);
  EXPECT_GT(report.iterations, 30);  // of both attempts
}

TEST_F(LinearSolverTest, WhatCannotBeBetteredInDoublesIsASolution) {
  LinearOptions options;
  options.method = Method::mumps;
  LinearSolver complete(problem.system(), options);
  EXPECT_NO_THROW(complete.solve(rhs, x, 1e-19));  // of the right-hand side: below rounding
  EXPECT_LE(error(), 1e-10);
  LinearSolver incomplete(problem.system(), {});
  EXPECT_THROW(incomplete.solve(rhs, x, 1e-19), SolveError);
}

TEST_F(LinearSolverTest, TooFewIterationsIsAnError) {
  LinearOptions options;
  options.max_iterations = 2;
  LinearSolver solver(problem.system(), options);
  try {
    solver.solve(rhs, x, 1e-12);
    FAIL() << "no error";
  } catch (const SolveError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("after 2 iterations"), std::string::npos) << text;
  }
}

TEST_F(LinearSolverTest, SingularMatrixIsAnError) {
  matrix->resumeFill();
  matrix->setAllToScalar(1.0);  // no row is zero, all are alike
  matrix->fillComplete();
  for (const auto method : {Method::gmres, Method::mumps, Method::blocks}) {
    LinearOptions options;
    options.method = method;
    options.max_iterations = 20;
    LinearSolver solver(problem.system(), options);
    EXPECT_THROW(solver.solve(rhs, x, 1e-8), SolveError);
  }
}

TEST_F(LinearSolverTest, ZeroRowOnOneRankIsAnErrorOnAll) {
  if (Communicator().is_root()) {
    const auto local = matrix->getLocalMatrixHost();
    for (auto k = local.graph.row_map(3); k < local.graph.row_map(4); ++k)
      local.values(k) = 0;
  }
  LinearSolver solver(problem.system(), {});
  try {
    solver.solve(rhs, x);
    FAIL() << "no error";
  } catch (const SolveError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("row 3 of the matrix is zero"), std::string::npos) << text;
  }
}

TEST_F(LinearSolverTest, ValuesThatAreNotFiniteAreErrors) {
  LinearSolver solver(problem.system(), {});
  solver.solve(rhs, x);
  if (Communicator().is_root()) rhs.replaceLocalValue(0, std::nan(""));
  EXPECT_THROW(solver.solve(rhs, x), SolveError);
  rhs.putScalar(1.0);
  EXPECT_NO_THROW(solver.solve(rhs, x));
  if (Communicator().is_root())
    matrix->getLocalMatrixHost().values(0) = std::numeric_limits<double>::infinity();
  solver.matrix_changed();
  EXPECT_THROW(solver.solve(rhs, x), SolveError);
}

TEST_F(LinearSolverTest, ZeroRightHandSideGivesZero) {
  LinearSolver solver(problem.system(), {});
  rhs.putScalar(0.0);
  x.putScalar(7.0);
  EXPECT_EQ(solver.solve(rhs, x).iterations, 0);
  EXPECT_EQ(x.norm2(), 0);
}

}  // namespace
}  // namespace hawser
