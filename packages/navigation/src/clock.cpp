#include "hawser/navigation/clock.hpp"

#include <cmath>
#include <cstdio>
#include <ctime>

namespace hawser {

std::string read_clock(const std::string& text, double& seconds) {
  std::string needed = "needed is a date and a time of UTC, such as 2026-05-03T10:00:00Z";
  std::tm given{};
  int read = 0;
  if (std::sscanf(text.c_str(), "%4d-%2d-%2dT%2d:%2d:%2dZ%n", &given.tm_year, &given.tm_mon,
                  &given.tm_mday, &given.tm_hour, &given.tm_min, &given.tm_sec, &read) != 6 ||
      static_cast<std::size_t>(read) != text.size() || text.size() != 20)
    return needed;
  given.tm_year -= 1900;
  given.tm_mon -= 1;
  std::tm normal = given;  // timegm makes the 2nd of March of a 30th of February
  const std::time_t time = timegm(&normal);
  const bool exists = normal.tm_mon == given.tm_mon && normal.tm_mday == given.tm_mday &&
                      normal.tm_hour == given.tm_hour && normal.tm_min == given.tm_min &&
                      normal.tm_sec == given.tm_sec;
  if (!exists || time < 0) return "there is no such day or time; " + needed;
  seconds = static_cast<double>(time);
  return "";
}

ClockTime clock_time(double seconds) {
  const auto whole = static_cast<std::time_t>(std::llround(seconds));
  std::tm utc{};
  gmtime_r(&whole, &utc);
  return {utc.tm_year + 1900, utc.tm_yday + 1, utc.tm_hour, utc.tm_min, utc.tm_sec};
}

}  // namespace hawser
