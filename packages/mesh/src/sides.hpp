#pragma once
#include <string>
#include <vector>

#include "body.hpp"

namespace hawser {

/// Numbers the split vertices of the mesh and of its body: doubled along the edges of the line
/// regions `slits`. MeshError.
void number_split_vertices(Mesh& mesh, const EdgeSides& sides,
                           const std::vector<std::string>& slits);

}  // namespace hawser
