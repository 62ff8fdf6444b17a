#pragma once
// Hyperelastic laws in the right Cauchy-Green tensor C = F^T F (theory.md, equations 2-4). In the
// plane the strain across it is zero.
#include <cmath>

#include "hawser/base/tensor.hpp"

namespace hawser {

enum class ElasticLaw { st_venant_kirchhoff, neo_hookean };

/// Lame's parameters, Pa, from Young's modulus and Poisson's ratio.
template <class P>
struct LameParameters {
  P first;  ///< lambda
  P shear;  ///< mu

  LameParameters(const P& young, double poisson)
      : first(young * (poisson / ((1 + poisson) * (1 - 2 * poisson)))),
        shear(young * (0.5 / (1 + poisson))) {}
};

/// F = I + grad d.
template <class T, int D>
Tensor<T, D> deformation(const Tensor<T, D>& displacement_gradient) {
  Tensor<T, D> F = displacement_gradient;
  for (int i = 0; i < D; ++i)
    F(i, i) += 1.0;
  return F;
}

/// E = (F^T F - I)/2 from grad d alone: 1 is never subtracted, which would cost digits.
template <class T, int D>
Tensor<T, D> green_lagrange(const Tensor<T, D>& displacement_gradient) {
  Tensor<T, D> strain;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      T sum = displacement_gradient(i, j) + displacement_gradient(j, i);
      for (int k = 0; k < D; ++k)
        sum += displacement_gradient(k, i) * displacement_gradient(k, j);
      strain(i, j) = 0.5 * sum;
    }
  return strain;
}

/// C = F^T F = I + 2 E.
template <class T, int D>
Tensor<T, D> right_cauchy_green(const Tensor<T, D>& strain) {
  Tensor<T, D> right;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j)
      right(i, j) = 2.0 * strain(i, j);
    right(i, i) += 1.0;
  }
  return right;
}

/// A : B.
template <class A, class B, int D>
Product<A, B> contract(const Tensor<A, D>& a, const Tensor<B, D>& b) {
  Product<A, B> sum = a(0, 0) * b(0, 0);
  for (int k = 1; k < D * D; ++k)
    sum += a(k / D, k % D) * b(k / D, k % D);
  return sum;
}

/// Second Piola-Kirchhoff stress, Pa, at the strain E.
///   St Venant and Kirchhoff:  S = lambda tr(E) I + 2 mu E
///   neo-Hooke:                S = mu (I - C^-1) + lambda ln(J) C^-1
template <class T, class P, int D>
Tensor<T, D> second_piola(ElasticLaw law, const Tensor<T, D>& strain,
                          const LameParameters<P>& lame) {
  Tensor<T, D> stress;
  if (law == ElasticLaw::st_venant_kirchhoff) {
    const T volumetric = lame.first * trace(strain);
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j)
        stress(i, j) = 2.0 * lame.shear * strain(i, j);
      stress(i, i) += volumetric;
    }
    return stress;
  }
  using std::log;
  const Tensor<T, D> right = right_cauchy_green(strain);
  const T squared = determinant(right);  // J^2
  const Tensor<T, D> adjoint = adjugate(right);
  const T factor = (0.5 * lame.first * log(squared) - lame.shear) / squared;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j)
      stress(i, j) = factor * adjoint(i, j);
    stress(i, i) += lame.shear;
  }
  return stress;
}

/// The energy per reference volume whose derivative by E that stress is, J/m^3.
template <class T, class P, int D>
T strain_energy_density(ElasticLaw law, const Tensor<T, D>& strain, const LameParameters<P>& lame) {
  const T volume_change = trace(strain);
  if (law == ElasticLaw::st_venant_kirchhoff)
    return 0.5 * lame.first * volume_change * volume_change + lame.shear * contract(strain, strain);
  using std::log;
  const T log_volume = 0.5 * log(determinant(right_cauchy_green(strain)));
  return lame.shear * (volume_change - log_volume) + 0.5 * lame.first * log_volume * log_volume;
}

/// Gonzalez' discrete gradient of the energy between two strains: times their difference it is just
/// what the energy gains (J. Nonlinear Sci. 6 (1996) 449-467). For St Venant and Kirchhoff's law it
/// is the stress at the mean strain.
template <class T, class P, int D>
Tensor<T, D> mean_stress(ElasticLaw law, const Tensor<double, D>& before, const Tensor<T, D>& after,
                         const LameParameters<P>& lame) {
  Tensor<T, D> middle, change, start;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      start(i, j) = before(i, j);
      middle(i, j) = 0.5 * (before(i, j) + after(i, j));
      change(i, j) = after(i, j) - before(i, j);
    }
  Tensor<T, D> stress = second_piola(law, middle, lame);
  // The rest is of third order in the change: below this it is lost in round-off.
  constexpr double negligible = 1e-14;
  const T squared = contract(change, change);
  if (law == ElasticLaw::st_venant_kirchhoff || squared < negligible) return stress;
  const T gain = strain_energy_density(law, after, lame) - strain_energy_density(law, start, lame) -
                 contract(stress, change);
  const T factor = gain / squared;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      stress(i, j) += factor * change(i, j);
  return stress;
}

}  // namespace hawser
