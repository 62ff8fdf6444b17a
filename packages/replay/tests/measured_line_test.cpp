// From a file's line to one that can be replayed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hawser/replay/comparison.hpp"
#include "lines.hpp"

namespace hawser {
namespace {

using testing::HasSubstr;

LineOptions at_speed(double speed) {
  LineOptions options;
  options.speed = speed;
  options.spacing = 12.5;
  return options;
}

std::string fault(const NavigationLine& line, const LineOptions& options) {
  Diagnostics diagnostics;
  prepare_line(line, options, diagnostics);
  return diagnostics.error_text();
}

TEST(MeasuredLine, CountsFromTheHeadAndTheFirstShot) {
  Diagnostics diagnostics;
  const MeasuredLine line = prepare_line(straight_line(10, 21), at_speed(2.5), diagnostics);
  ASSERT_TRUE(diagnostics.ok()) << diagnostics.error_text();
  EXPECT_EQ(line.origin, (Place{5000, 7000}));
  EXPECT_DOUBLE_EQ(line.length(), 2000);
  EXPECT_NEAR(line.times.back(), 9 * 50 / 2.5, 1e-9);
  EXPECT_NEAR(line.places[3][2][0], 150 - 200, 1e-12);
  EXPECT_NEAR(line.shape.front()[0], 0, 1e-9);
  EXPECT_NEAR(line.speed, 2.5, 1e-9);
  // Straight along its track, the path in the water is what the cable does.
  EXPECT_NEAR(compare(line, follow_the_path(line)).rms, 0, 1e-6);
}

TEST(MeasuredLine, FindsTheHeadByItsMotion) {
  NavigationLine backward = straight_line(10, 21);
  for (Shot& shot : backward.shots)
    std::reverse(shot.places.begin(), shot.places.end());
  Diagnostics diagnostics;
  const MeasuredLine line = prepare_line(backward, at_speed(2.5), diagnostics);
  ASSERT_TRUE(diagnostics.ok()) << diagnostics.error_text();
  EXPECT_EQ(line.receivers.front(), 160);
  EXPECT_EQ(line.receivers.back(), 0);
  EXPECT_DOUBLE_EQ(line.arc_lengths[1], 100);
  EXPECT_EQ(line.origin, (Place{5000, 7000}));
}

TEST(MeasuredLine, MissingReceiversAreLeftOut) {
  NavigationLine line = straight_line(12, 21);
  line.shots[5].places[0] = {no_value, no_value};  // the head: bridged
  line.shots[7].places[4] = {no_value, no_value};
  Diagnostics diagnostics;
  const MeasuredLine ready = prepare_line(line, at_speed(2.5), diagnostics);
  ASSERT_TRUE(diagnostics.ok()) << diagnostics.error_text();
  EXPECT_NEAR(ready.times[5], 5 * 50 / 2.5, 1e-9);
  const Comparison found = compare(ready, follow_the_path(ready));
  EXPECT_EQ(found.count, 12 * 21 - 2);
  EXPECT_NEAR(found.rms, 0, 1e-6);
}

TEST(MeasuredLine, TellsWhatCannotBe) {
  const NavigationLine good = straight_line(12, 21);
  EXPECT_THAT(fault(good, {}), HasSubstr("the file has no times; --speed 2.3 would say"));
  LineOptions options = at_speed(2.5);
  options.spacing = 50;
  EXPECT_THAT(fault(good, options),
              HasSubstr("are 12.5 m apart (median), and the spacing is said to be "
                        "50 m; are shot and receiver mixed up?"));
  NavigationLine line = good;
  for (std::size_t s = 0; s < line.shots.size(); ++s)
    line.shots[s].time = 20.0 * static_cast<double>(s);
  EXPECT_THAT(fault(line, at_speed(2.5)), HasSubstr("a speed would contradict them"));
  for (std::size_t s = 6; s < line.shots.size(); ++s)
    line.shots[s].time += 300;
  options = {};
  EXPECT_THAT(fault(line, options),
              HasSubstr("line.csv:8:1: the head is not known for 320 s before this "
                        "shot, and 20 s are usual (median); --longest-gap 320"));
  options.longest_gap = 320;
  EXPECT_EQ(fault(line, options), "");
  line = good;
  line.shots[4].places[0][0] += 5000;
  EXPECT_THAT(fault(line, at_speed(2.5)),
              HasSubstr("line.csv:6:1: the head is 5050 m from where it was"));
  line = good;
  line.shots[0].places[20] = {no_value, no_value};
  EXPECT_THAT(fault(line, at_speed(2.5)),
              HasSubstr("receiver 160, the tail of the cable, is missing in shot 100"));
}

}  // namespace
}  // namespace hawser
