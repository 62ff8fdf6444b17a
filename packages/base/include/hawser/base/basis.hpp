#pragma once
// The shape functions a field may have, and their values at quadrature points as plain arrays.
#include <vector>

namespace hawser {

enum class Basis {
  p1,  ///< continuous, linear; one point per vertex
  p2   ///< continuous, quadratic; one point per vertex, then one per edge
};

/// Shape functions on the reference cell at the points of one quadrature rule.
struct Tabulation {
  int points = 0;               ///< quadrature points
  int nodes = 0;                ///< shape functions
  int dimension = 0;            ///< of the reference cell
  std::vector<double> weights;  ///< [point]; they sum to the reference cell's measure
  std::vector<double>
      locations;  ///< [point][dimension], reference-cell coordinates in the unit simplex
  std::vector<double> values;  ///< [point][node]
  std::vector<double>
      gradients;  ///< [point][node][dimension], with respect to reference-cell coordinates
};

}  // namespace hawser
