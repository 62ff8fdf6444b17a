#pragma once
#include <vector>

#include "body.hpp"

namespace hawser {

/// Vertices of the boundary of a body in the plane that lie on a boundary edge which does not end
/// there, no more than `distance` (m) away from it: what is meshed apart and with other nodes.
/// Ascending.
std::vector<LocalIndex> hanging_vertices(const Mesh& mesh, const EdgeSides& sides, double distance);

}  // namespace hawser
