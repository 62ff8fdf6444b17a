#include <algorithm>
#include <cmath>

#include "hawser/replay/comparison.hpp"

namespace hawser {
namespace {

/// A polyline by the way along it.
struct Path {
  std::vector<Place> points;
  std::vector<double> along;  // m

  void add(const Place& place) {
    const double way = points.empty() ? 0
                                      : along.back() + std::hypot(place[0] - points.back()[0],
                                                                  place[1] - points.back()[1]);
    points.push_back(place);
    along.push_back(way);
  }
  Place at(double way) const {
    const auto above = std::upper_bound(along.begin() + 1, along.end() - 1, way);
    const auto i = static_cast<std::size_t>(above - along.begin());
    const double share = (way - along[i - 1]) / (along[i] - along[i - 1]);
    return {points[i - 1][0] + share * (points[i][0] - points[i - 1][0]),
            points[i - 1][1] + share * (points[i][1] - points[i - 1][1])};
  }
};

}  // namespace

Positions follow_the_path(const MeasuredLine& line) {
  constexpr int pieces = 4;  // between two shots
  Path path;
  for (auto place = line.shape.rbegin(); place != line.shape.rend(); ++place)
    path.add({(*place)[0], (*place)[1]});
  std::vector<double> way_of_shot = {path.along.back()};
  for (std::size_t s = 1; s < line.times.size(); ++s) {
    for (int p = 1; p <= pieces; ++p)
      path.add(line.head_at(line.times[s - 1] + (line.times[s] - line.times[s - 1]) * p / pieces));
    way_of_shot.push_back(path.along.back());
  }
  Positions positions;
  for (const double way : way_of_shot) {
    std::vector<Place>& shot = positions.emplace_back();
    for (const double arc : line.arc_lengths)
      shot.push_back(path.at(way - arc));
  }
  return positions;
}

}  // namespace hawser
