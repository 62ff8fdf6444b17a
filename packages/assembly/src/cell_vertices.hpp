#pragma once
// Cells by their vertices, whatever region lists them.
#include <algorithm>
#include <set>
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

using Vertices = std::vector<LocalIndex>;

inline Vertices sorted_vertices(const Region& region, LocalIndex cell) {
  const auto n = static_cast<std::ptrdiff_t>(region.vertices_per_cell);
  const auto first = region.vertices.begin() + static_cast<std::ptrdiff_t>(cell) * n;
  Vertices vertices(first, first + n);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/// Of this rank.
inline void insert_cells(const Region& region, std::set<Vertices>& cells) {
  for (LocalIndex cell = 0; cell < region.size(); ++cell)
    cells.insert(sorted_vertices(region, cell));
}

}  // namespace hawser
