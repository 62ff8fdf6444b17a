#include "hawser/values/expression_source.hpp"

#include <gtest/gtest.h>

namespace hawser {
namespace {

TEST(ExpressionSource, GivesEachComponentWithItsExactDerivatives) {
  const ExpressionSource source({Expression("x^2*t + y"), Expression("X*t^3"), Expression(5)});
  ASSERT_EQ(source.components(), 3);
  const SpaceTime at{3, 4, 0, 7, 8, 0, 2};
  double values[3], rates[3], slope[3];
  source.value(at, values);
  source.time_derivative(at, rates);
  source.gradient(at, 0, slope);
  EXPECT_EQ(values[0], 22);
  EXPECT_EQ(values[1], 56);
  EXPECT_EQ(values[2], 5);
  EXPECT_EQ(rates[0], 9);
  EXPECT_EQ(rates[1], 84);
  EXPECT_EQ(rates[2], 0);
  EXPECT_EQ(slope[0], 12);
  EXPECT_EQ(slope[1], 1);
  EXPECT_EQ(slope[2], 0);
}

TEST(ExpressionSource, KnowsWhichComponentsFollowTheMovedPosition) {
  const ExpressionSource source({Expression("x"), Expression("X*t")});
  EXPECT_TRUE(source.depends_on_moved_position(0));
  EXPECT_FALSE(source.depends_on_moved_position(1));
  EXPECT_TRUE(source.depends_on_moved_position());
}

}  // namespace
}  // namespace hawser
