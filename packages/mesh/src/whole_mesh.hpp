#pragma once
// The whole mesh as rank 0 prepares it: a Mesh whose local numbers are the rank-independent ones.
// Owners of vertices, edges and cells are not known yet and left empty.
#include <string>
#include <vector>

#include "hawser/mesh/mesh.hpp"
#include "msh_file.hpp"

namespace hawser {

/// A region without cells yet.
Region make_region(const std::string& name, CellShape shape);

/// Vertices, coordinates and the regions of the file, checked; triangles counter-clockwise. No
/// topology. MeshError.
Mesh check_and_number(const MshFile& file, int dimension);

/// Adds edges, split vertices, patches and facets. MeshError.
void add_topology(Mesh& mesh, const std::vector<std::string>& slits);

}  // namespace hawser
