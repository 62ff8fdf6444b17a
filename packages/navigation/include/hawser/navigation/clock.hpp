#pragma once
// When on the calendar t = 0 is. UTC throughout, without leap seconds, as POSIX counts.
#include <string>

namespace hawser {

struct ClockTime {
  int year = 0, day_of_year = 0, hour = 0, minute = 0, second = 0;
};

/// Sets `seconds` since 1970 from "2026-05-03T10:00:00Z" and returns "", or what is wrong.
std::string read_clock(const std::string& text, double& seconds);
/// Rounded to whole seconds, as P1/90 has them.
ClockTime clock_time(double seconds);

}  // namespace hawser
