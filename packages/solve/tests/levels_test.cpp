#include "src/levels.hpp"

#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include "hawser/base/error.hpp"
#include "hawser/solve/nonlinear_driver.hpp"
#include "pointwise_problem.hpp"

namespace hawser {
namespace {

using test::PointwiseProblem;

PointwiseProblem problem() {
  return {[](double x) { return 3 * (x - 1e7); }, [](double) { return 3.0; }};
}

TEST(Levels, MeetTheResidual) {
  auto linear = problem();
  linear.system().blocks[0].has_level = true;
  const auto x = linear.guess(2);
  auto f = linear.guess(0), magnitude = linear.guess(0);
  linear.residual(x, f, magnitude);
  linear.jacobian(x);
  TpetraVector levelled(x, Teuchos::Copy);
  EXPECT_TRUE(level_fields(linear.system(), f, levelled));
  EXPECT_NEAR(levelled.meanValue(), 1e7, 1e-6);
}

TEST(Levels, StayWhereTheyAreNoGreatHelp) {
  auto linear = problem();
  auto f = linear.guess(1);
  for (GlobalIndex row = 0; row < 10; row += 2)
    f.replaceGlobalValue(row, -1.1);
  linear.jacobian(f);
  auto x = linear.guess(2);
  EXPECT_FALSE(level_fields(linear.system(), f, x));  // no field has one
  linear.system().blocks[0].has_level = true;
  EXPECT_FALSE(level_fields(linear.system(), f, x));  // up here, down there
  EXPECT_EQ(x.meanValue(), 2);
}

TEST(Levels, ThatNothingHoldsAreNamed) {
  decltype(problem()) linear = {[](double) { return 1.0; }, [](double) { return 0.0; }};
  linear.system().blocks[0].has_level = true;
  const auto f = linear.guess(1);
  auto x = linear.guess(2);
  linear.jacobian(x);
  try {
    level_fields(linear.system(), f, x);
    FAIL() << "no error";
  } catch (const SolveError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("nothing holds the level of the field '", 0), 0u);
  }
}

// All that is relative to a first residual is then relative to one without the level.
TEST(Levels, AreInPlaceBeforeNewtonBegins) {
  for (const bool has_level : {false, true}) {
    auto linear = problem();
    linear.system().blocks[0].has_level = has_level;
    auto x = linear.guess(0);
    EXPECT_EQ(NonlinearDriver(linear, {}, {}).solve(x).iterations, has_level ? 0 : 1);
    EXPECT_NEAR(x.meanValue(), 1e7, 1e-6);
  }
}

}  // namespace
}  // namespace hawser
