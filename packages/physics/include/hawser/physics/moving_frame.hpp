#pragma once
// From the reference mesh to the moved one: x = X + d, F = I + grad d, J = det F.
#include "hawser/base/tensor.hpp"

namespace hawser {

template <class T, int D>
struct MovingFrame {
  Tensor<T, D> inverse;  ///< F^-1
  T volume;              ///< J

  explicit MovingFrame(const Tensor<T, D>& displacement_gradient) {
    Tensor<T, D> F = displacement_gradient;
    for (int i = 0; i < D; ++i)
      F(i, i) += 1.0;
    volume = determinant(F);
    inverse = adjugate(F);
    const T scale = 1.0 / volume;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        inverse(i, j) *= scale;
  }

  bool inverted() const { return !(volume > 0.0); }

  /// Gradient with respect to x from the one with respect to X, of a scalar or a vector.
  template <class Gradient>
  auto spatial(const Gradient& gradient) const {
    return multiply(gradient, inverse);
  }

  /// Flux per reference area from a flux per moved area: J f F^-T (Piola transform).
  template <class A>
  Tensor<Product<A, T>, D> pull_back(const Tensor<A, D>& flux) const {
    Tensor<Product<A, T>, D> result;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        Product<A, T> sum = flux(i, 0) * inverse(j, 0);
        for (int k = 1; k < D; ++k)
          sum += flux(i, k) * inverse(j, k);
        result(i, j) = volume * sum;
      }
    return result;
  }
  template <class A>
  Vector<Product<A, T>, D> pull_back(const Vector<A, D>& flux) const {
    Vector<Product<A, T>, D> result = multiply(inverse, flux);
    for (int i = 0; i < D; ++i)
      result[i] *= volume;
    return result;
  }
};

}  // namespace hawser
