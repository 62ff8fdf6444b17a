#include "hawser/element/cell_geometry.hpp"

namespace hawser {

double stretch_at(int q, const Quadrature& rule, const Tabulation& geometry, const double* X) {
  const int dimension = traits(rule.shape).dimension;
  double side[3][3] = {};  // [k] = dX / d xi_k
  for (int a = 0; a < geometry.nodes; ++a)
    for (int k = 0; k < dimension; ++k)
      for (int j = 0; j < 3; ++j)
        side[k][j] +=
            geometry.gradients[static_cast<std::size_t>((q * geometry.nodes + a) * dimension + k)] *
            X[3 * a + j];
  const double(&a)[3] = side[0], (&b)[3] = side[1], (&c)[3] = side[2];
  if (dimension == 1) return std::hypot(a[0], a[1], a[2]);
  const double normal[] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                           a[0] * b[1] - a[1] * b[0]};
  if (dimension == 2) return std::hypot(normal[0], normal[1], normal[2]);
  return std::abs(normal[0] * c[0] + normal[1] * c[1] + normal[2] * c[2]);
}

}  // namespace hawser
