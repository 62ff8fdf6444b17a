#pragma once
#include <utility>
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

/// Pairs of vertices, the lower one first, ascending, that are no more than `distance` apart (m, at
/// least 0). `spacing` is about that of all others and much more than `distance`. In O(n log n).
std::vector<std::pair<LocalIndex, LocalIndex>> coincident_vertices(const Mesh& mesh,
                                                                   double distance, double spacing);

}  // namespace hawser
