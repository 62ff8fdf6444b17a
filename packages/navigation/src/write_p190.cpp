#include "hawser/navigation/write_p190.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/navigation/clock.hpp"

namespace hawser {
namespace {

/// A number in its columns.
std::string fitted(const std::string& text, std::size_t width, const char* what) {
  if (text.size() > width)
    throw OutputError(
        fmt::format("{} {} does not fit the {} columns that P1/90 has for it", what, text, width));
  return text;
}
std::string fixed(double value, std::size_t width, const char* what) {
  return fitted(std::isnan(value) ? std::string(width, ' ') : fmt::format("{:{}.1f}", value, width),
                width, what);
}

std::string header(const std::string& type, const std::string& description,
                   const std::string& data) {
  return fmt::format("H{}{:<27}{:<48}\n", type, description, data.substr(0, 48));
}

/// dddmmss.ss with a letter for the sign.
std::string degrees(double value, int width, char positive, char negative) {
  const long long hundredths = std::llround(std::abs(value) * 360000);
  const long long seconds = hundredths / 100;
  return fmt::format(
      "{:0{}d}{:02d}{:05.2f}{}", seconds / 3600, width, seconds / 60 % 60,
      static_cast<double>(seconds % 60) + static_cast<double>(hundredths % 100) / 100,
      value < 0 ? negative : positive);
}

std::string headers(const NavigationLine& line, const Chart& chart, const P190Options& options) {
  const ClockTime first = clock_time(options.epoch + line.shots.front().time);
  return header("0100", "SURVEY AREA", "") + header("0202", "TAPE VERSION", "UKOOA P1/90") +
         header("0200", "DATE OF SURVEY",
                fmt::format("{:04d} DAY {:03d}", first.year, first.day_of_year)) +
         header("0203", "LINE PREFIX", options.line) +
         header("0600", "POSITIONING PROCESSING", "HAWSER, COMPUTED POSITIONS OF A MODEL") +
         header("0800", "COORDINATE LOCATION", "S AND V: HEAD OF THE STREAMER") +
         header("1000", "CLOCK TIME", "GMT") +
         header("1100", "RECEIVER GROUPS PER SHOT", fmt::format("{}", line.receivers.size())) +
         header("1400", "GEODETIC DATUM AS SURVEYED", chart.datum() + " " + chart.ellipsoid()) +
         header("1500", "GEODETIC DATUM AS PLOTTED", chart.datum() + " " + chart.ellipsoid()) +
         header("1700", "VERTICAL DATUM", "SEA SURFACE") +
         header("1800", "PROJECTION", chart.name()) +
         header("1900", "PROJECTION ZONE", chart.crs()) + header("2000", "GRID UNITS", "METRES") +
         header("2001", "FACTOR TO METRE", "1.00000000") +
         header("2002", "ANGULAR UNITS", "DEGREES") +
         header("2600", "OTHER", "COMPUTED BY A MODEL, NOT MEASURED");
}

}  // namespace

std::string write_p190(const NavigationLine& line, const Chart& chart, const P190Options& options) {
  std::string text = headers(line, chart, options);
  const std::string name = fitted(options.line, 12, "the name of the line");
  for (const Shot& shot : line.shots) {
    const Place& head = shot.places.front();
    const Chart::Geographic at = chart.geographic(head);
    const ClockTime time = clock_time(options.epoch + shot.time);
    for (const char mark : {'V', 'S'})
      text += fmt::format("{}{:<12}   1{} {}{}{}{}{}{:>6}{:03d}{:02d}{:02d}{:02d} \n", mark, name,
                          mark == 'S' ? '1' : ' ',
                          fitted(fmt::format("{:6d}", shot.number), 6, "the number of shot"),
                          degrees(at.latitude, 2, 'N', 'S'), degrees(at.longitude, 3, 'E', 'W'),
                          fixed(head[0], 9, "easting"), fixed(head[1], 9, "northing"),
                          options.depth > 0 ? fixed(options.depth, 6, "depth of the water") : "",
                          time.day_of_year, time.hour, time.minute, time.second);
    for (std::size_t r = 0; r < line.receivers.size(); r += 3) {
      std::string record = "R";
      for (std::size_t i = r; i < std::min(r + 3, line.receivers.size()); ++i)
        record += fitted(fmt::format("{:4d}", line.receivers[i]), 4, "the receiver's number") +
                  fixed(shot.places[i][0], 9, "easting") + fixed(shot.places[i][1], 9, "northing") +
                  fixed(shot.depths.empty() ? no_value : shot.depths[i], 4, "the cable's depth");
      text += fmt::format("{:<79}{}\n", record, options.streamer);
    }
  }
  return text + "EOF\n";
}

}  // namespace hawser
