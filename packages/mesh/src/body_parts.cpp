#include "body_parts.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "boxes.hpp"
#include "whole_mesh.hpp"

namespace hawser {
namespace {

/// Vertices of one part alone, and the middles of all cells.
std::vector<Place> places_of(const Mesh& mesh, const BodyParts& parts) {
  constexpr LocalIndex none = -1, several = -2;
  std::vector<LocalIndex> part_of(mesh.vertices.ids.size(), none);
  std::vector<Place> places;
  for (LocalIndex c = 0; c < mesh.body.size(); ++c) {
    const auto mine = parts.of_cell[at(c)];
    Place middle{{0, 0}, mine, mesh.body.vertices[at(3 * c)]};
    for (int k = 0; k < 3; ++k) {
      const auto v = mesh.body.vertices[at(3 * c + k)];
      auto& part = part_of[at(v)];
      part = part == none || part == mine ? mine : several;
      for (std::size_t j = 0; j < 2; ++j)
        middle.x[j] += mesh.coordinates[2 * at(v) + j] / 3;
    }
    places.push_back(middle);
  }
  for (LocalIndex v = 0; v < mesh.vertices.size(); ++v)
    if (part_of[at(v)] >= 0)
      places.push_back(
          {{mesh.coordinates[2 * at(v)], mesh.coordinates[2 * at(v) + 1]}, part_of[at(v)], v});
  return places;
}

/// Inside by more than the round-off of what lies on its sides.
bool inside(const double* p, const double* a, const double* b, const double* c) {
  const auto area = [](const double* u, const double* v, const double* w) {
    return (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0]);
  };
  const double least = 1e-6 * area(a, b, c);
  return area(a, b, p) > least && area(b, c, p) > least && area(c, a, p) > least;
}

}  // namespace

BodyParts find_parts(const Mesh& mesh, const EdgeSides& sides) {
  std::vector<LocalIndex> parent(mesh.body.cell_ids.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](LocalIndex c) {
    while (parent[at(c)] != c)
      c = parent[at(c)] = parent[at(parent[at(c)])];
    return c;
  };
  for (LocalIndex edge = 0; edge < mesh.edges.size(); ++edge) {
    if (sides.count(edge) != 2) continue;
    const auto a = root(sides.left(edge)), b = root(sides.right(edge));
    parent[at(std::max(a, b))] = std::min(a, b);
  }
  BodyParts parts;
  parts.of_cell.resize(parent.size());
  for (LocalIndex c = 0; c < mesh.body.size(); ++c)  // a root is its part's first cell
    parts.of_cell[at(c)] = root(c) == c ? parts.count++ : parts.of_cell[at(root(c))];
  return parts;
}

std::vector<LocalIndex> vertices_inside_other_parts(const Mesh& mesh, const BodyParts& parts) {
  const Boxes boxes(places_of(mesh, parts));
  std::vector<LocalIndex> found;
  for (LocalIndex c = 0; c < mesh.body.size(); ++c) {
    const double* corner[3];
    std::array<double, 2> low, high;
    for (int k = 0; k < 3; ++k)
      corner[k] = &mesh.coordinates[at(2 * mesh.body.vertices[at(3 * c + k)])];
    for (std::size_t j = 0; j < 2; ++j) {
      low[j] = std::min({corner[0][j], corner[1][j], corner[2][j]});
      high[j] = std::max({corner[0][j], corner[1][j], corner[2][j]});
    }
    boxes.within(low, high, [&](const Place& place) {
      if (place.part != parts.of_cell[at(c)] &&
          inside(place.x.data(), corner[0], corner[1], corner[2]))
        found.push_back(place.vertex);
    });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace hawser
