#include "hawser/navigation/clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hawser {
namespace {

using testing::HasSubstr;

double seconds_of(const std::string& text) {
  double seconds = -1;
  EXPECT_EQ(read_clock(text, seconds), "");
  return seconds;
}

TEST(Clock, CountsFrom1970) {
  EXPECT_EQ(seconds_of("1970-01-01T00:00:00Z"), 0);
  EXPECT_EQ(seconds_of("2000-03-01T00:00:00Z"), 951868800);  // after a leap day of a leap century
  EXPECT_EQ(seconds_of("2026-05-03T10:00:01Z"), 1777802401);
}

TEST(Clock, KnowsTheDayOfTheYear) {
  const ClockTime leap = clock_time(seconds_of("2024-12-31T23:59:59Z"));
  EXPECT_EQ(leap.year, 2024);
  EXPECT_EQ(leap.day_of_year, 366);
  EXPECT_EQ(leap.second, 59);
  const ClockTime next = clock_time(seconds_of("2024-12-31T23:59:59Z") + 0.6);
  EXPECT_EQ(next.year, 2025);
  EXPECT_EQ(next.day_of_year, 1);
  EXPECT_EQ(next.hour + next.minute + next.second, 0);
}

TEST(Clock, RefusesWhatIsNoTime) {
  double seconds = 0;
  for (const char* const wrong : {"", "2026-05-03", "2026-05-03 10:00:00Z", "2026-05-03T10:00:00",
                                  "2026-5-03T10:00:00Z", "2026-05-03T10:00:00Zx"})
    EXPECT_THAT(read_clock(wrong, seconds), HasSubstr("needed is a date")) << wrong;
  for (const char* const none :
       {"2026-02-29T10:00:00Z", "2026-13-03T10:00:00Z", "2026-04-31T10:00:00Z",
        "2026-05-03T24:00:00Z", "2026-05-03T10:60:00Z", "2026-05-00T10:00:00Z",
        "1969-12-31T10:00:00Z"})
    EXPECT_THAT(read_clock(none, seconds), HasSubstr("there is no such day or time")) << none;
}

}  // namespace
}  // namespace hawser
