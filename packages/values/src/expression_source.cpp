#include "hawser/values/expression_source.hpp"

#include <algorithm>

namespace hawser {

void ExpressionSource::value(const SpaceTime& at, double* values) const {
  for (const Expression& formula : formulas_)
    *values++ = formula(at);
}

void ExpressionSource::time_derivative(const SpaceTime& at, double* rates) const {
  for (const Expression& formula : formulas_)
    *rates++ = formula.time_derivative(at);
}

void ExpressionSource::gradient(const SpaceTime& at, int component, double* slope) const {
  const auto found = formulas_[static_cast<std::size_t>(component)].tangent(at).gradient;
  std::copy(found.begin(), found.end(), slope);
}

bool ExpressionSource::depends_on_moved_position(int component) const {
  return formulas_[static_cast<std::size_t>(component)].depends_on_moved_position();
}

}  // namespace hawser
