#include "hanging.hpp"

#include <algorithm>
#include <cmath>

#include "boxes.hpp"
#include "whole_mesh.hpp"

namespace hawser {
namespace {

/// Beside the inner part of the segment from a to b.
bool on_segment(const double* p, const double* a, const double* b, double distance) {
  const double way[] = {b[0] - a[0], b[1] - a[1]}, to[] = {p[0] - a[0], p[1] - a[1]};
  const double length = std::hypot(way[0], way[1]);
  const double along = (to[0] * way[0] + to[1] * way[1]) / length;
  const double across = (to[1] * way[0] - to[0] * way[1]) / length;
  return along > distance && along < length - distance && std::abs(across) <= distance;
}

}  // namespace

std::vector<LocalIndex> hanging_vertices(const Mesh& mesh, const EdgeSides& sides,
                                         double distance) {
  std::vector<LocalIndex> edges, vertices;
  for (LocalIndex e = 0; e < mesh.edges.size(); ++e)
    if (sides.on_boundary(e)) {
      edges.push_back(e);
      vertices.insert(vertices.end(), {mesh.edge_ends[at(2 * e)], mesh.edge_ends[at(2 * e + 1)]});
    }
  if (edges.empty()) return {};
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<Place> places;
  for (const auto v : vertices)
    places.push_back({{mesh.coordinates[2 * at(v)], mesh.coordinates[2 * at(v) + 1]}, 0, v});
  const Boxes boxes(std::move(places));
  std::vector<LocalIndex> found;
  for (const auto e : edges) {
    const double* const a = &mesh.coordinates[2 * at(mesh.edge_ends[at(2 * e)])];
    const double* const b = &mesh.coordinates[2 * at(mesh.edge_ends[at(2 * e + 1)])];
    std::array<double, 2> low, high;
    for (std::size_t j = 0; j < 2; ++j) {
      low[j] = std::min(a[j], b[j]) - distance;
      high[j] = std::max(a[j], b[j]) + distance;
    }
    boxes.within(low, high, [&](const Place& place) {
      if (on_segment(place.x.data(), a, b, distance)) found.push_back(place.vertex);
    });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace hawser
