#include "hawser/physics/moving_frame.hpp"

#include <gtest/gtest.h>

namespace hawser {
namespace {

TEST(MovingFrame, InvertsF) {
  Tensor<double, 2> gradient;
  gradient(0, 0) = 0.5, gradient(0, 1) = 0.2, gradient(1, 0) = -0.1, gradient(1, 1) = 0.25;
  const MovingFrame<double, 2> frame(gradient);
  EXPECT_NEAR(frame.volume, 1.5 * 1.25 + 0.02, 1e-15);
  Tensor<double, 2> F = gradient;
  F(0, 0) += 1, F(1, 1) += 1;
  const auto one = multiply(F, frame.inverse);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      EXPECT_NEAR(one(i, j), i == j ? 1 : 0, 1e-15);
  EXPECT_FALSE(frame.inverted());
}

TEST(MovingFrame, AFlatOrTurnedCellIsInverted) {
  for (const double stretch : {-1.0, -1.5}) {
    Tensor<double, 3> gradient;
    gradient(1, 1) = stretch;
    EXPECT_TRUE((MovingFrame<double, 3>(gradient).inverted()));
  }
}

// Twice as wide: the flux across a face of normal x is spread over as much area as before, the one
// across a face of normal y over twice as much.
TEST(MovingFrame, PullsFluxesBackByArea) {
  Tensor<double, 2> gradient;
  gradient(0, 0) = 1;
  const MovingFrame<double, 2> frame(gradient);
  const auto flux = frame.pull_back(Vector<double, 2>{{3, 5}});
  EXPECT_EQ(flux[0], 3);
  EXPECT_EQ(flux[1], 10);
}

}  // namespace
}  // namespace hawser
