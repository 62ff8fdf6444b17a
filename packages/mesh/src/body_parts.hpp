#pragma once
#include <vector>

#include "body.hpp"

namespace hawser {

/// Parts of a body that share no edge.
struct BodyParts {
  std::vector<LocalIndex> of_cell;  ///< part of each cell; numbered by their first cells
  LocalIndex count = 0;
};

BodyParts find_parts(const Mesh& mesh, const EdgeSides& sides);

/// Vertices of one part that are inside a cell of another, or of cells whose middles are; triangles
/// in the plane. Ascending.
std::vector<LocalIndex> vertices_inside_other_parts(const Mesh& mesh, const BodyParts& parts);

}  // namespace hawser
