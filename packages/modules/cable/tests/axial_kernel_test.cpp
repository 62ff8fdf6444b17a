#include "axial_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser {
namespace {

CableProperties sample() {
  CableProperties cable;
  cable.axial_stiffness = 1e7;
  cable.slack_width = 1e-5;
  return cable;
}

TEST(SlackTension, IsHookesAboveAndNothingBelow) {
  const CableProperties cable = sample();
  EXPECT_DOUBLE_EQ(slack_tension(1e-3, cable), 1e4);
  EXPECT_EQ(slack_tension(-1e-3, cable), 0);
  EXPECT_DOUBLE_EQ(slack_tension(0.0, cable), 25);  // EA width / 4
}

TEST(SlackTension, IsContinuouslyDifferentiable) {
  const CableProperties cable = sample();
  for (const double edge : {-1e-5, 1e-5}) {
    const double h = 1e-9;
    const double before = (slack_tension(edge, cable) - slack_tension(edge - h, cable)) / h;
    const double after = (slack_tension(edge + h, cable) - slack_tension(edge, cable)) / h;
    EXPECT_NEAR(before, after, 1e-3 * cable.axial_stiffness);
    EXPECT_NEAR(slack_tension(edge + 1e-15, cable), slack_tension(edge - 1e-15, cable), 1e-6);
  }
}

TEST(SlackTension, KeepsAShareInCompression) {
  CableProperties cable = sample();
  cable.compressive_ratio = 0.1;
  EXPECT_DOUBLE_EQ(slack_tension(-1e-3, cable), -1e3);
  EXPECT_DOUBLE_EQ(slack_tension(1e-3, cable), 1e4);
}

TEST(Segment, MeasuresStrainFromTheDisplacement) {
  const double X[2][2] = {{0, 0}, {3, 4}}, d[2][2] = {{1, 1}, {1.3, 1.4}};
  const Segment<double, 2> segment([&](int a, int i) { return X[a][i]; },
                                   [&](int a, int i) { return d[a][i]; });
  EXPECT_DOUBLE_EQ(segment.length, 5);
  EXPECT_NEAR(segment.strain, (1.1 * 1.1 - 1) / 2, 1e-15);  // 10 % longer, same direction
  EXPECT_NEAR(std::sqrt(dot(segment.stretch, segment.stretch)), 1.1, 1e-15);
}

}  // namespace
}  // namespace hawser
