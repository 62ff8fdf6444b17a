#pragma once
// Quadrature rules, and shape functions at their points, as plain arrays.
#include <vector>

#include "hawser/element/basis.hpp"

namespace hawser {

struct Quadrature {
  CellShape shape = CellShape::triangle;
  int points = 0;
  std::vector<double> weights;    ///< [point]; they sum to the reference cell's measure
  std::vector<double> locations;  ///< [point][dimension], reference coordinates
};

/// Shape functions at the points of a rule.
struct Tabulation {
  int nodes = 0;
  std::vector<double> values;     ///< [point][node]
  std::vector<double> gradients;  ///< [point][node][dimension], by reference coordinates
  bool linear = false;            ///< the gradients are those of the first point everywhere
};

/// What a kernel computes with: its fields and the cell's own geometry at the points of one rule.
struct CellTabulation {
  Quadrature rule;
  Tabulation geometry;             ///< of the map from the reference cell
  bool affine = true;              ///< that map is affine on every cell
  std::vector<Tabulation> fields;  ///< in the order of the kernel's
};

/// Exact for polynomials of `degree` (per direction on quadrilaterals and hexahedra).
Quadrature quadrature(CellShape shape, int degree);

/// On the facet of the cell on which its last reference coordinate vanishes (of a triangle the edge
/// from its first to its second vertex); the weights sum to that facet's reference measure.
Quadrature facet_quadrature(CellShape shape, int degree);

Tabulation tabulate(Basis basis, const Quadrature& rule);

/// Fields of these bases on cells with straight edges.
CellTabulation tabulate_cell(const std::vector<Basis>& fields, const Quadrature& rule);

}  // namespace hawser
