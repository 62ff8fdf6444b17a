#pragma once
// Vertices and their neighbours, as METIS and Cuthill-McKee want them.
#include <vector>

#include "hawser/base/types.hpp"

namespace hawser {

struct Graph {
  std::vector<LocalIndex> offsets = {0};  ///< neighbours of v: [offsets[v], offsets[v + 1])
  std::vector<LocalIndex> neighbours;     ///< ascending per vertex
  LocalIndex size() const { return static_cast<LocalIndex>(offsets.size()) - 1; }
  LocalIndex degree(LocalIndex v) const;
};

/// `ends` holds the two ends of each edge, one edge after the other, no edge twice.
Graph make_graph(LocalIndex vertices, const std::vector<LocalIndex>& ends);

/// An order of the vertices in which neighbours are close together: incomplete factorisations lose
/// less that way. Element k is the vertex that comes k-th.
std::vector<LocalIndex> reverse_cuthill_mckee(const Graph& graph);

/// A part for every vertex. METIS where it is at its best, slices of consecutive vertices where
/// there are too few of them; the same on every run.
std::vector<int> partition(const Graph& graph, int parts);

}  // namespace hawser
