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

/// SolveError, naming the cell and where it started, when a cell of the body is inside out. What
/// moves the mesh need not see it itself: linear elasticity folds a cell without a word, and a
/// module that lives on the cell would only stumble over it in the next step. Collective.
void refuse_tangled_mesh(const DofMap& dofs, const State& state);

}  // namespace hawser
