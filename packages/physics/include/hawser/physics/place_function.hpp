#pragma once
// A deck's expression where a kernel needs it: at a point that moves with the mesh.
#include <Sacado.hpp>

#include <type_traits>

#include "hawser/base/tensor.hpp"
#include "hawser/deck/expression.hpp"

namespace hawser {

/// The expression at the reference position X (m) displaced by d (m). A T that carries derivatives
/// receives those with respect to d. SolveError when the result or a derivative is not finite; the
/// assembler raises it on all ranks.
template <class T, int D>
T at_place(const Expression& expression, const Vector<double, D>& X, const Vector<T, D>& d,
           double time) {
  static_assert(D <= 3, "a place has at most three coordinates");
  if (expression.is_constant()) return expression({});
  constexpr double SpaceTime::*moved[] = {&SpaceTime::x, &SpaceTime::y, &SpaceTime::z};
  constexpr double SpaceTime::*reference[] = {&SpaceTime::X, &SpaceTime::Y, &SpaceTime::Z};
  SpaceTime place;
  place.t = time;
  for (int j = 0; j < D; ++j) {
    place.*reference[j] = X[j];
    place.*moved[j] = X[j] + Sacado::ScalarValue<T>::eval(d[j]);
  }
  if constexpr (std::is_same_v<T, double>) {
    return expression(place);
  } else {
    const Expression::Tangent tangent = expression.tangent(place);
    T result = tangent.value;
    for (int j = 0; j < D; ++j)
      result += tangent.gradient[static_cast<std::size_t>(j)] *
                (d[j] - Sacado::ScalarValue<T>::eval(d[j]));
    return result;
  }
}

}  // namespace hawser
