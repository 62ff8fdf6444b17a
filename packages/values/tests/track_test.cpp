#include "hawser/values/track.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace hawser {
namespace {

using testing::HasSubstr;
using Point = std::array<double, 2>;

TrackDeck deck(const std::vector<std::vector<double>>& points, double radius = 100) {
  TrackDeck result;
  result.name.value = "line";
  result.speed = 2;
  result.start = 50;
  result.ramp = 40;
  result.turn_radius = radius;
  for (const auto& point : points)
    result.way_points.push_back({point});
  return result;
}

std::string fault(const TrackDeck& given) {
  std::string text =
      "<track name='line' speed='2' turn-radius='" + std::to_string(given.turn_radius) + "'>";
  for (const auto& point : given.way_points)
    text +=
        "<way-point at='" + std::to_string(point.at[0]) + " " + std::to_string(point.at[1]) + "'/>";
  Diagnostics diagnostics;
  TrackDeck::spec().read(parse_deck(text + "</track>", "deck.xml", diagnostics).root, diagnostics);
  return diagnostics.error_text();
}

TEST(Track, StartsAtTheFirstWayPointAndFollowsTheLegs) {
  const Track track(deck({{10, 20}, {10, 1000}, {-500, 1000}}));
  EXPECT_EQ(track.position(0), (Point{10, 20}));
  EXPECT_NEAR(track.course(0)[1], 1, 1e-15);
  // 20 s of the ramp count half.
  EXPECT_NEAR(track.position(150)[1], 20 + 2 * (150 - 50 - 20), 1e-12);
  EXPECT_NEAR(track.velocity(150)[1], 2, 1e-12);
  const double late = 50 + 20 + track.length() / 2 + 10;
  EXPECT_NEAR(track.position(late)[0], -500 - 20, 1e-9);
  EXPECT_NEAR(track.position(late)[1], 1000, 1e-9);
  EXPECT_NEAR(track.velocity(late)[0], -2, 1e-9);
  double displacement[2];
  SpaceTime now;
  now.t = late;
  track.value(now, displacement);
  EXPECT_NEAR(displacement[0], -530, 1e-9);
}

TEST(Track, IsUnderWayAtItsStartWithoutARamp) {
  TrackDeck under_way = deck({{10, 20}, {10, 1000}});
  under_way.ramp = 0;
  const Track track(under_way);
  EXPECT_NEAR(track.position(50)[1], 20, 1e-12);
  EXPECT_NEAR(track.position(0)[1], 20 - 2 * 50, 1e-12);
  EXPECT_NEAR(track.velocity(0)[1], 2, 1e-15);
  EXPECT_NEAR(track.position(150)[1], 20 + 2 * 100, 1e-12);
}

// Differences of position, velocity and acceleration over a step shrink with the step everywhere,
// the joints of ramps, legs and turns included: C2, with bounded third differences.
TEST(Track, IsTwiceContinuouslyDifferentiable) {
  const Track track(deck({{0, 0}, {0, 600}, {700, 600}, {1000, 300}}));
  const auto acceleration = [&](double t) {
    constexpr double h = 1e-3;
    const Point a = track.velocity(t - h), b = track.velocity(t + h);
    return Point{(b[0] - a[0]) / (2 * h), (b[1] - a[1]) / (2 * h)};
  };
  double greatest_jerk = 0;
  for (double t = 40; t < 900; t += 0.05) {
    constexpr double h = 0.05;
    const Point x0 = track.position(t - h), x1 = track.position(t + h), v = track.velocity(t);
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_NEAR((x1[j] - x0[j]) / (2 * h), v[j], 1e-4) << t;
      const double jump = acceleration(t + h)[j] - acceleration(t)[j];
      greatest_jerk = std::max(greatest_jerk, std::abs(jump) / h);
    }
  }
  // The ramp's largest third derivative is 10 sqrt(3)/3 v/T^2 = 5.77 * 2/40^2 = 0.0072 m/s^3; the
  // turns' is smaller. A jump of the acceleration by 0.001 m/s^2 would show as 0.02.
  EXPECT_LT(greatest_jerk, 0.0075);
  EXPECT_GT(greatest_jerk, 0.0065);
}

TEST(Track, KeepsItsSpeedAndRadiusInATurn) {
  const Track track(deck({{0, 0}, {0, 1000}, {1000, 1000}}));
  double tightest = 1e9, nearest = 1e9;
  for (double t = 100; t < 1000; t += 0.1) {
    const Point v = track.velocity(t), a = track.velocity(t - 0.01), b = track.velocity(t + 0.01);
    EXPECT_NEAR(std::hypot(v[0], v[1]), 2, 1e-12);
    const double change = std::hypot(b[0] - a[0], b[1] - a[1]) / 0.02;
    if (change > 0) tightest = std::min(tightest, 4 / change);
    const Point x = track.position(t);
    nearest = std::min(nearest, std::hypot(x[0], x[1] - 1000));
  }
  EXPECT_NEAR(tightest, 100, 0.01);
  EXPECT_GT(nearest, 30);  // the turn cuts the way-point
  EXPECT_LT(nearest, 100);
}

TEST(Track, SaysWhatIsWrong) {
  EXPECT_THAT(fault(deck({{0, 0}})), HasSubstr("at least two way-points"));
  EXPECT_THAT(fault(deck({{0, 0}, {0, 0}})), HasSubstr("way-points 1 and 2 are the same"));
  EXPECT_THAT(fault(deck({{0, 0}, {0, 500}, {500, 500}}, 0)),
              HasSubstr("the turn at way-point 2 needs a turn-radius"));
  EXPECT_THAT(fault(deck({{0, 0}, {0, 500}, {0, 100}})), HasSubstr("turns back on itself"));
  EXPECT_THAT(
      fault(deck({{0, 0}, {0, 100}, {500, 100}})),
      HasSubstr("deck.xml:1:2: track 'line': the leg from way-point 1 to 2 is 100 m long, and "
                "its turns need"));
  EXPECT_EQ(fault(deck({{0, 0}, {0, 500}, {500, 500}})), "");
  EXPECT_EQ(fault(deck({{0, 0}, {0, 500}, {0, 900}}, 0)), "");
}

}  // namespace
}  // namespace hawser
