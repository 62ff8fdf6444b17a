#pragma once
#include "hawser/base/basis.hpp"
#include "hawser/mesh/mesh.hpp"

namespace hawser {

/// Shapes of `basis` on the unit simplex of `shape` (line: [0, 1]) at the points of a quadrature
/// rule that is exact for polynomials of `degree`.
Tabulation tabulate(CellShape shape, Basis basis, int degree);

}  // namespace hawser
