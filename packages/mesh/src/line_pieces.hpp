#pragma once
// Connected pieces of a set of edges, for messages.
#include <string>
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

struct LinePiece {
  LocalIndex edges = 0;
  double length = 0;             ///< m
  std::vector<LocalIndex> ends;  ///< vertices where one edge ends, ascending; none of a ring
  LocalIndex first = 0;          ///< vertex with the lowest number
};

double edge_length(const Mesh& mesh, LocalIndex edge);  ///< m

/// In the order of their first vertices.
std::vector<LinePiece> line_pieces(const Mesh& mesh, const std::vector<LocalIndex>& edges);

/// "from (0, 0) to (4, 0), 4 m; a ring through (1, 1), 6 m; and 2 more".
std::string describe_pieces(const Mesh& mesh, const std::vector<LinePiece>& pieces);

}  // namespace hawser
