#pragma once
// The metric of a moved cell, from which the time scales of stabilised methods are made (Bazilevs
// et al., Comput. Methods Appl. Mech. Engrg. 197 (2007) 173-201).
#include <cmath>

#include "hawser/base/tensor.hpp"

namespace hawser {

namespace detail {
/// Of the map from the regular simplex of edge 2: sum_kl 2 (1 + delta_kl) dxi_k/dx dxi_l/dx.
template <class T, int D>
void simplex_metric(const Tensor<T, D>& to_cell, Tensor<T, D>& metric) {
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j) {
      T sum_i = to_cell(0, i);
      T sum_j = to_cell(0, j);
      T sum = to_cell(0, i) * to_cell(0, j);
      for (int k = 1; k < D; ++k) {
        sum += to_cell(k, i) * to_cell(k, j);
        sum_i += to_cell(k, i);
        sum_j += to_cell(k, j);
      }
      metric(i, j) = 2.0 * (sum + sum_i * sum_j);
      metric(j, i) = metric(i, j);
    }
}

/// Of the map from the square or cube of edge 2: sum_k 4 dxi_k/dx dxi_k/dx.
template <class T, int D>
void cube_metric(const Tensor<T, D>& to_cell, Tensor<T, D>& metric) {
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      T sum = to_cell(0, i) * to_cell(0, j);
      for (int k = 1; k < D; ++k)
        sum += to_cell(k, i) * to_cell(k, j);
      metric(i, j) = 4.0 * sum;
    }
}
}  // namespace detail

/// G, 1/m^2: 4/h^2 for an equilateral cell or a square of edge h. It is taken from the regular
/// cell, so that the numbering of vertices does not matter. `at` is a point of a MovingPointKernel.
template <class Point>
auto cell_metric(const Point& at) {
  using T = typename Point::Number;
  const Tensor<T, Point::dimension> to_cell = at.inverse_jacobian();
  Tensor<T, Point::dimension> metric;
  if (at.reference.shape->simplex)
    detail::simplex_metric(to_cell, metric);
  else
    detail::cube_metric(to_cell, metric);
  return metric;
}

/// (c.G c + C k^2 G:G)^1/2, 1/s, of a field of linear shapes that is carried by c (m/s) and spread
/// by k (m^2/s): the inverse of the time scale of its subscale.
template <class T, int D, class K>
T subscale_rate(const Tensor<T, D>& metric, const Vector<T, D>& c, const K& k) {
  using std::sqrt;
  constexpr double inverse_estimate = 36.0;  // C, of linear shapes
  T squared = 0.0;                           // G:G
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j)
      squared += (i == j ? 1.0 : 2.0) * metric(i, j) * metric(i, j);
  constexpr double at_rest = 1e-30;  // 1/s^2: without flow and spreading it has a slope, too
  return sqrt(at_rest + dot(c, multiply(metric, c)) + inverse_estimate * k * k * squared);
}

}  // namespace hawser
