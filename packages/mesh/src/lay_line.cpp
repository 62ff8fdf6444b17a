// A cable laid along a polyline: chords of equal length, found one after the other.
#include <algorithm>
#include <array>
#include <cmath>

#include "hawser/deck/value.hpp"
#include "hawser/mesh/generate.hpp"

namespace hawser {
namespace {

using Place = std::array<double, 3>;

/// A curve may be longer than the cable by this share, the noise of what was measured.
constexpr double greatest_excess = 0.05;

Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Place between(const Place& a, const Place& b, double share) {
  const Place way = minus(b, a);
  return {a[0] + share * way[0], a[1] + share * way[1], a[2] + share * way[2]};
}

/// Along from + share (to - from): the greatest share at which it is `distance` from `centre`,
/// which is nearer to `from` than that.
double share_at(const Place& centre, const Place& from, const Place& to, double distance) {
  const Place way = minus(to, from), start = minus(from, centre);
  const double a = dot(way, way), b = dot(way, start);
  const double c = dot(start, start) - distance * distance;
  return (std::sqrt(std::max(0.0, b * b - a * c)) - b) / a;
}

std::string metres(double length) { return write_value(std::round(length * 100) / 100) + " m"; }

}  // namespace

std::string lay_line(const std::vector<Place>& points, int dimension, double length, int segments,
                     std::vector<double>& nodes) {
  double along = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    along += std::sqrt(dot(minus(points[i], points[i - 1]), minus(points[i], points[i - 1])));
  const std::string lengths =
      "the shape is " + metres(along) + " long, and the cable " + metres(length);
  if (along > (1 + greatest_excess) * length)
    return lengths +
           ": it would be stretched; give the length that the cable has, or a shape that ends "
           "with it";
  const double segment = length / segments;
  std::vector<Place> laid = {points.front()};
  Place here = points.front();  // on the curve, where the search goes on
  std::size_t next = 1;         // the curve's point behind it
  for (int i = 0; i < segments; ++i) {
    const Place& centre = laid.back();
    while (next < points.size() &&
           dot(minus(points[next], centre), minus(points[next], centre)) < segment * segment)
      here = points[next++];
    const bool ends = next == points.size();
    const double left = std::sqrt(dot(minus(points.back(), centre), minus(points.back(), centre)));
    if (ends && (i + 1 < segments || left < 0.5 * segment))
      return lengths + ": " + metres(length - i * segment - left) +
             " of it have no place; a shape is needed that goes on to the cable's end, or a "
             "shorter "
             "cable";
    if (ends)  // straight on
      here = between(centre, points.back(), segment / left);
    else
      here = between(here, points[next], share_at(centre, here, points[next], segment));
    laid.push_back(here);
  }
  nodes.clear();
  for (const Place& place : laid)
    nodes.insert(nodes.end(), place.begin(), place.begin() + dimension);
  return "";
}

}  // namespace hawser
