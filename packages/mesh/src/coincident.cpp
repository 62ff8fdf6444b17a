#include "coincident.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "whole_mesh.hpp"

namespace hawser {
namespace {

struct Entry {
  std::uint64_t box;  // hash of its numbers: boxes that share one only cost a comparison
  LocalIndex vertex;
};

std::int64_t box(double x, double spacing) {
  constexpr double most = 9e18;
  return static_cast<std::int64_t>(std::clamp(std::floor(x / spacing), -most, most));
}

std::uint64_t mixed(std::uint64_t hash, std::int64_t number) {
  hash ^= static_cast<std::uint64_t>(number) + 0x9e3779b97f4a7c15U + (hash << 6U) + (hash >> 2U);
  return hash * 0xff51afd7ed558ccdU;
}

double squared_distance(const Mesh& mesh, LocalIndex a, LocalIndex b) {
  double squared = 0;
  for (int j = 0; j < mesh.dimension; ++j) {
    const double way =
        mesh.coordinates[at(mesh.dimension * a + j)] - mesh.coordinates[at(mesh.dimension * b + j)];
    squared += way * way;
  }
  return squared;
}

}  // namespace

// Every vertex is entered in each box of a grid that its surroundings touch: nearly always one.
std::vector<std::pair<LocalIndex, LocalIndex>> coincident_vertices(const Mesh& mesh,
                                                                   double distance,
                                                                   double spacing) {
  std::vector<Entry> entries;
  entries.reserve(mesh.vertices.ids.size() * 9 / 8);
  for (LocalIndex v = 0; v < mesh.vertices.size(); ++v) {
    std::array<std::array<std::int64_t, 2>, 3> range{};
    for (int j = 0; j < mesh.dimension; ++j) {
      // Shifted, so that the nodes of a regular grid do not lie on the boxes' sides.
      const double x = mesh.coordinates[at(mesh.dimension * v + j)] + 0.317 * spacing;
      range[at(j)] = {box(x - distance, spacing), box(x + distance, spacing)};
    }
    for (auto i = range[0][0]; i <= range[0][1]; ++i)
      for (auto j = range[1][0]; j <= range[1][1]; ++j)
        for (auto k = range[2][0]; k <= range[2][1]; ++k)
          entries.push_back({mixed(mixed(mixed(0, i), j), k), v});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.box != b.box ? a.box < b.box : a.vertex < b.vertex;
  });
  // Of a heap of nodes at one place not every pair is wanted.
  constexpr std::size_t most = 64;
  std::vector<std::pair<LocalIndex, LocalIndex>> pairs;
  for (std::size_t first = 0; first < entries.size(); ++first)
    for (std::size_t other = first + 1;
         other < std::min(entries.size(), first + most) && entries[other].box == entries[first].box;
         ++other)
      if (squared_distance(mesh, entries[first].vertex, entries[other].vertex) <=
          distance * distance)
        pairs.emplace_back(entries[first].vertex, entries[other].vertex);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace hawser
