#pragma once
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

/// Fills values[point][width] of the ghost points with those of their owners. Collective.
void exchange_ghosts(const Communicator& communicator, const PointSet& points, std::size_t width,
                     std::vector<GlobalIndex>& values);

}  // namespace hawser
