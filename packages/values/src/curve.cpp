#include "hawser/values/curve.hpp"

#include <cmath>

#include "hawser/deck/value.hpp"
#include "hawser/values/number_columns.hpp"

namespace hawser {
namespace {

enum Known : std::size_t { arc_length, x, y, z };

/// A chord may be longer than the cable between its ends by this share: the noise of fixes.
constexpr double stretch_of_noise = 0.1;

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

double Curve::length() const {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    sum += distance(points[i - 1], points[i]);
  return sum;
}

Curve read_curve(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.error_count();
  const Csv csv = read_csv(text, file, diagnostics);
  if (diagnostics.error_count() > before) return {};
  const std::vector<KnownColumn> known = {{{"arc_length"}, "m", false, false},
                                          {{"x", "east"}, "m", true, false},
                                          {{"y", "north"}, "m", true, false},
                                          {{"z"}, "m", false, false}};
  const NumberColumns columns = read_number_columns(csv, known, diagnostics);
  if (diagnostics.error_count() > before) return {};
  Curve curve;
  curve.dimension = columns.given[z] ? 3 : 2;
  curve.arc_lengths = columns.values[arc_length];
  for (std::size_t i = 0; i < csv.rows.size(); ++i)
    curve.points.push_back(
        {columns.values[x][i], columns.values[y][i], columns.given[z] ? columns.values[z][i] : 0});
  const auto fault = [&](std::size_t row, Known column, const std::string& sentence) {
    diagnostics.error(csv.place(csv.rows[row], columns.cells[column]), sentence);
  };
  if (curve.points.size() < 2) fault(0, x, "a curve needs two places at least");
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const double chord = i == 0 ? 0 : distance(curve.points[i - 1], curve.points[i]);
    if (i > 0 && chord == 0) fault(i, x, "the place is that of the row before");
    if (curve.arc_lengths.empty()) continue;
    const double along = curve.arc_lengths[i] - (i == 0 ? 0 : curve.arc_lengths[i - 1]);
    if (i == 0 && along != 0)
      fault(i, arc_length, "the arc length counts from the first place, where it is 0");
    else if (i > 0 && along <= 0)
      fault(i, arc_length, "the arc length does not grow from the row before");
    else if (chord > (1 + stretch_of_noise) * along && i > 0)
      fault(i, arc_length,
            "the place is " + write_value(std::round(100 * chord) / 100) +
                " m from that of the row before, and " + write_value(along) +
                " m of cable are between them");
    if (diagnostics.error_count() > before + most_told) break;
  }
  return curve;
}

}  // namespace hawser
