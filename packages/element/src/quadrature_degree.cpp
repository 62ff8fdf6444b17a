#include "hawser/element/quadrature_degree.hpp"

#include <algorithm>

namespace hawser {

int quadrature_degree(CellShape shape, const std::vector<FieldInForm>& fields) {
  const ShapeTraits& cell = traits(shape);
  int value = 0, gradient = 1, test = 1;
  for (const FieldInForm& field : fields) {
    if (field.value) value = std::max(value, polynomial_degree(field.basis));
    if (field.gradient) gradient = std::max(gradient, polynomial_degree(field.basis));
    if (field.tested) test = std::max(test, polynomial_degree(field.basis));
  }
  if (value > 0) return value + gradient - 1 + test + (cell.simplex ? 0 : cell.dimension - 1);
  return cell.simplex ? gradient - 1 + test - 1 : gradient + test;
}

}  // namespace hawser
