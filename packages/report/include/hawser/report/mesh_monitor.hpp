#pragma once
// Least mesh quality and largest Courant number of the moved mesh.
#include "hawser/fields/dof_map.hpp"
#include "hawser/fields/state.hpp"

namespace hawser {

struct MeshFigures {
  double least_quality = 1;  ///< 1 is equilateral
  double courant = 0;        ///< |c| dt over the cell's length along c = v - w
};

/// Over all triangles. Collective.
MeshFigures inspect_mesh(const DofMap& dofs, const State& state);

}  // namespace hawser
