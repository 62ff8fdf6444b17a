#pragma once
#include <vector>

#include "hawser/element/basis.hpp"

namespace hawser {

/// How one field enters a weak form.
struct FieldInForm {
  Basis basis;
  bool value;     ///< its value or rate is looked at
  bool gradient;  ///< its gradient is
  bool tested;    ///< the form has rows for it
};

/// The degree that integrates a form exactly on straight cells as far as it is a product of the
/// unknowns, each as high as it comes:
///   - value . gradient . test function (convection; with it, value . test function, the mass), of
///     degree V + (G - 1) + T for bases of the degrees V, G and T;
///   - gradient . gradient of a test function, where no value is looked at: (G - 1) + (T - 1).
/// On quadrilaterals and hexahedra the degree counts per direction: a derivative lowers only one of
/// them, and the map of a straight cell with its n - 1 factors beside the gradient has degree n
/// - 1. Quotients and roots (stabilisation, a moved geometry of degree 2) have no exact rule. For
/// linear triangles that is 2, and 0 where only gradients count; 5 when all is quadratic.
int quadrature_degree(CellShape shape, const std::vector<FieldInForm>& fields);

}  // namespace hawser
