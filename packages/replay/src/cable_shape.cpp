#include <cmath>

#include "src/preparation.hpp"

namespace hawser {
namespace {

constexpr double shape_periods = 6;  // of the shape's smoothing, in distances of receivers

/// As long as the cable and a little more: cut, or straight on at the tail.
void fit_length(std::vector<std::array<double, 3>>& shape, double length) {
  constexpr double more = 1.02;
  double along = 0;
  for (std::size_t i = 1; i < shape.size(); ++i) {
    along += std::hypot(shape[i][0] - shape[i - 1][0], shape[i][1] - shape[i - 1][1]);
    if (along > more * length) shape.resize(i + 1);
  }
  if (along >= more * length) return;
  const auto &last = shape.back(), &before = shape[shape.size() - 2];
  const double step = std::hypot(last[0] - before[0], last[1] - before[1]);
  const double share = (more * length - along) / step;
  shape.push_back(
      {last[0] + share * (last[0] - before[0]), last[1] + share * (last[1] - before[1]), 0});
}

}  // namespace

void find_shape(const LineOptions& options, MeasuredLine& result) {
  std::vector<double> along, east, north;
  const auto& places = result.places.front();
  for (std::size_t r = 0; r < places.size(); ++r)
    if (is_known(places[r])) {
      along.push_back(result.arc_lengths[r]);
      east.push_back(places[r][0]);
      north.push_back(places[r][1]);
    }
  result.shape_smooth = options.shape_smooth.value_or(shape_periods * result.length() /
                                                      static_cast<double>(along.size() - 1));
  const SmoothingSpline x(along, east, result.shape_smooth), y(along, north, result.shape_smooth);
  // The head goes where its track begins; what that moves it by fades along the cable.
  const Place begin = result.head_at(0);
  const int points = 8 * static_cast<int>(along.size());
  const double length = result.length();
  for (int i = 0; i <= points; ++i) {
    const double share = static_cast<double>(i) / points, s = share * length;
    result.shape.push_back({x.value(s) + (1 - share) * (begin[0] - x.value(0)),
                            y.value(s) + (1 - share) * (begin[1] - y.value(0)), 0});
  }
  fit_length(result.shape, length);
}

}  // namespace hawser
