#pragma once
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

/// Gives each rank its part of the whole mesh, which only rank 0 has; `owner_of_vertex` likewise.
Mesh distribute(const Communicator& communicator, const Mesh& whole,
                const std::vector<int>& owner_of_vertex);

}  // namespace hawser
