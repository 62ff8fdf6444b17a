#include "hawser/report/observed_order.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser {
namespace {

TEST(ObservedOrder, OfAPowerIsItsExponentWithoutAnError) {
  std::vector<double> errors;
  for (int level = 0; level < 4; ++level)
    errors.push_back(3 * std::pow(2.0, -1.5 * level));
  const ObservedOrder order = observed_order(errors);
  ASSERT_EQ(order.pairs.size(), 3U);
  for (const double pair : order.pairs)
    EXPECT_NEAR(pair, 1.5, 1e-14);
  EXPECT_NEAR(order.fitted, 1.5, 1e-14);
  EXPECT_NEAR(order.standard_error.value(), 0, 1e-14);
}

TEST(ObservedOrder, FitsWithTheStandardErrorOfTheSlope) {
  // log2 of the errors: 0, -1, -1; slope -1/2, residuals -1/6, 1/3, -1/6.
  const ObservedOrder order = observed_order({1, 0.5, 0.5});
  EXPECT_EQ(order.pairs, (std::vector<double>{1, 0}));
  EXPECT_NEAR(order.fitted, 0.5, 1e-15);
  EXPECT_NEAR(order.standard_error.value(), std::sqrt(1.0 / 12), 1e-15);
}

TEST(ObservedOrder, OfTwoLevelsHasNoStandardError) {
  EXPECT_FALSE(observed_order({4, 1}).standard_error.has_value());
  EXPECT_EQ(observed_order({4, 1}).fitted, 2);
}

}  // namespace
}  // namespace hawser
