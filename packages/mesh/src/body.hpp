#pragma once
// The cells that fill the space, and which of them meet at an edge.
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

/// Makes `mesh.body` the union of the regions of its dimension, numbered in their order; their
/// cells' numbers are those in the body from then on, ascending.
void unite_body(Mesh& mesh);

/// Gives a region of body cells the vertices, split vertices and edges that these have in the body
/// of the whole mesh.
void copy_from_body(const Region& body, Region& region);

/// Who is on either side of an edge of a body in the plane.
class EdgeSides {
 public:
  /// MeshError where cells overlap.
  explicit EdgeSides(const Mesh& mesh);

  int count(LocalIndex edge) const { return (left(edge) >= 0) + (right(edge) >= 0); }
  bool on_boundary(LocalIndex edge) const { return count(edge) == 1; }
  /// Cells of the body beside the edge as it runs from its lower to its higher end; -1: none.
  LocalIndex left(LocalIndex edge) const { return cells_[static_cast<std::size_t>(2 * edge)]; }
  LocalIndex right(LocalIndex edge) const { return cells_[static_cast<std::size_t>(2 * edge + 1)]; }

 private:
  std::vector<LocalIndex> cells_;  // [edge][2]
};

}  // namespace hawser
