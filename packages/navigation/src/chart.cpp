#include "hawser/navigation/chart.hpp"

#include <fmt/format.h>
#include <proj.h>

#include <cmath>
#include <cstdio>

#include "hawser/base/error.hpp"

namespace hawser {

struct Chart::Handles {
  struct Destroy {
    void operator()(PJ* handle) const { proj_destroy(handle); }
    void operator()(PJ_CONTEXT* handle) const { proj_context_destroy(handle); }
  };
  using Handle = std::unique_ptr<PJ, Destroy>;
  std::unique_ptr<PJ_CONTEXT, Destroy> context{proj_context_create()};
  Handle chart, geodetic, way;
};

Chart::Chart(const std::string& crs) : crs_(crs), handles_(std::make_unique<Handles>()) {
  PJ_CONTEXT* const context = handles_->context.get();
  proj_log_level(context, PJ_LOG_NONE);
  handles_->chart.reset(proj_create(context, crs.c_str()));
  const auto fault = [&](const std::string& why) {
    return DeckError(
        quoted(crs) + " " + why +
        "; needed is a projected system in metres, such as EPSG:32631, UTM zone 31 north on "
        "WGS 84");
  };
  PJ* const chart = handles_->chart.get();
  if (chart == nullptr) throw fault("is no coordinate reference system that PROJ knows");
  if (proj_get_type(chart) != PJ_TYPE_PROJECTED_CRS) throw fault("is no projected system");
  const Handles::Handle axes(proj_crs_get_coordinate_system(context, chart));
  double factor = 0;
  proj_cs_get_axis_info(context, axes.get(), 0, nullptr, nullptr, nullptr, &factor, nullptr,
                        nullptr, nullptr);
  if (factor != 1) throw fault("is not in metres");
  handles_->geodetic.reset(proj_crs_get_geodetic_crs(context, chart));
  const Handles::Handle way(
      proj_create_crs_to_crs_from_pj(context, chart, handles_->geodetic.get(), nullptr, nullptr));
  // East before north and longitude before latitude, whatever the system's own order.
  handles_->way.reset(proj_normalize_for_visualization(context, way.get()));
  if (!handles_->way) throw fault("cannot be converted to latitude and longitude");
}

Chart::~Chart() = default;

Chart::Geographic Chart::geographic(const Place& place) const {
  const PJ_COORD at = proj_trans(handles_->way.get(), PJ_FWD, proj_coord(place[0], place[1], 0, 0));
  if (!std::isfinite(at.xy.x) || !std::isfinite(at.xy.y))
    throw DeckError(
        fmt::format("easting {:.1f} m, northing {:.1f} m is no place on the chart {}; is the "
                    "origin right?",
                    place[0], place[1], crs_));
  return {at.xy.y, at.xy.x};
}

std::string Chart::name() const { return proj_get_name(handles_->chart.get()); }
std::string Chart::datum() const { return proj_get_name(handles_->geodetic.get()); }

std::string Chart::ellipsoid() const {
  PJ_CONTEXT* const context = handles_->context.get();
  const Handles::Handle ellipsoid(proj_get_ellipsoid(context, handles_->geodetic.get()));
  double axis = 0, inverse_flattening = 0;
  proj_ellipsoid_get_parameters(context, ellipsoid.get(), &axis, nullptr, nullptr,
                                &inverse_flattening);
  return fmt::format("{} {:.3f} {:.7f}", proj_get_name(ellipsoid.get()), axis, inverse_flattening);
}

namespace {

/// Days since 1970 of the first of January.
long long days_before(int year) {
  const long long y = year - 1;
  return 365 * (y - 1969) + (y / 4 - 1969 / 4) - (y / 100 - 1969 / 100) + (y / 400 - 1969 / 400);
}

bool is_leap(int year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0; }

}  // namespace

std::string read_clock(const std::string& text, double& seconds) {
  std::string needed = "needed is a date and a time of UTC, such as 2026-05-03T10:00:00Z";
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0, read = 0;
  if (std::sscanf(text.c_str(), "%4d-%2d-%2dT%2d:%2d:%2dZ%n", &year, &month, &day, &hour, &minute,
                  &second, &read) != 6 ||
      static_cast<std::size_t>(read) != text.size() || text.size() != 20)
    return needed;
  const int lengths[] = {31, is_leap(year) ? 29 : 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  if (year < 1970 || month < 1 || month > 12 || day < 1 || day > lengths[month - 1] || hour < 0 ||
      hour > 23 || minute < 0 || minute > 59 || second < 0 || second > 59)
    return "there is no such day or time; " + needed;
  long long days = days_before(year) + day - 1;
  for (int m = 1; m < month; ++m)
    days += lengths[m - 1];
  seconds = 86400.0 * static_cast<double>(days) + 3600 * hour + 60 * minute + second;
  return "";
}

ClockTime clock_time(double seconds) {
  const long long whole = std::llround(seconds);
  const long long days = whole / 86400, of_day = whole % 86400;
  ClockTime time;
  time.year = 1970;
  while (days_before(time.year + 1) <= days)
    ++time.year;
  time.day_of_year = static_cast<int>(days - days_before(time.year)) + 1;
  time.hour = static_cast<int>(of_day / 3600);
  time.minute = static_cast<int>(of_day % 3600 / 60);
  time.second = static_cast<double>(of_day % 60);
  return time;
}

}  // namespace hawser
