#pragma once
// An elastic body in its reference configuration, at a quadrature point (theory.md, equations 1-5).
#include <array>

#include "elastic_law.hpp"
#include "hawser/physics/point_kernel.hpp"

namespace hawser {

struct SolidProperties {
  ElasticLaw law = ElasticLaw::st_venant_kirchhoff;
  double poisson = 0.3;
  double damping = 0;    ///< external, of the velocity per mass, 1/s
  double viscosity = 0;  ///< internal, of the rate of the Green-Lagrange strain, Pa s
};

namespace property {
constexpr PropertyUse young_modulus{"young modulus", "Pa"};
}

template <int D>
class SolidKernel : public PointKernel<SolidKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<D>::velocity.as(Role::adds, need::value | need::rate | need::gradient),
      StandardFields<D>::displacement.as(Role::kinematic, need::gradient | need::accepted)};
  static constexpr std::array<PropertyUse, 3> properties = {
      property::density, property::young_modulus, property::body_force<D>};
  static constexpr Slot<0> velocity{};
  static constexpr Slot<1> displacement{};
  static constexpr PropertySlot<0> density{};
  static constexpr PropertySlot<1> young{};
  static constexpr PropertySlot<2> body_force{};

  SolidKernel(Domain domain, const SolidProperties& solid, std::vector<PropertyConstant> constants)
      : PointKernel<SolidKernel>(std::move(domain), std::move(constants)), solid_(solid) {}

  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    const auto F = deformation(at[displacement].gradient);
    out.inverted = !(determinant(F) > 0.0);
    if (out.inverted) return;
    const auto& rho = at[density];
    const auto& v = at[velocity];
    for (int i = 0; i < D; ++i)
      out[velocity].source[i] = rho * (v.rate[i] + solid_.damping * v.value[i] - at[body_force][i]);
    auto stress = elastic_stress(at);
    if (solid_.viscosity > 0) {
      const auto rate = strain_rate(F, v.gradient);
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
          stress(i, j) += solid_.viscosity * rate(i, j);
    }
    out[velocity].flux = multiply(F, stress);  // first Piola-Kirchhoff; S is symmetric
  }

  std::vector<Kernel::Quantity> quantities() const override {
    std::vector<Kernel::Quantity> all = {{"stress_xx", "Pa"}, {"stress_yy", "Pa"}};
    if (D == 3) all.push_back({"stress_zz", "Pa"});
    all.push_back({"stress_xy", "Pa"});
    if (D == 3) {
      all.push_back({"stress_yz", "Pa"});
      all.push_back({"stress_zx", "Pa"});
    }
    return all;
  }
  /// Cauchy's stress, F S F^T / J, without what damps; the mean over the cell's moved volume.
  void evaluate(const CellInput& cell, double* values) const override {
    Tensor<double, D> sum;
    double volume = 0;
    this->at_points(cell, [&](const auto& at, double weight, int /*q*/, const auto& /*shapes*/) {
      const Tensor<double, D> F = deformation(at[displacement].gradient);
      const Tensor<double, D> piola = multiply(
          F, second_piola(solid_.law, green_lagrange(at[displacement].gradient), lame(at)));
      volume += weight * determinant(F);
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
          for (int k = 0; k < D; ++k)
            sum(i, j) += weight * piola(i, k) * F(j, k);
    });
    for (int i = 0; i < D; ++i)
      *values++ = sum(i, i) / volume;
    for (int i = 0; i < (D == 3 ? 3 : 1); ++i)
      *values++ = sum(i, (i + 1) % D) / volume;
  }

  std::vector<EnergyTerm> energy_terms() const override {
    using Kind = EnergyTerm::Kind;
    return {{"kinetic", Kind::stored},
            {"strain", Kind::stored},
            {"body force", Kind::supplied},
            {"internal damping", Kind::dissipated},
            {"external damping", Kind::dissipated}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    std::fill(powers, powers + 5, 0.0);
    this->at_points(cell, [&](const auto& at, double weight, int /*q*/, const auto& /*shapes*/) {
      const double rho = at[density];
      const auto& v = at[velocity];
      const auto rate = strain_rate(deformation(at[displacement].gradient), v.gradient);
      const auto stress = elastic_stress(at);
      const double terms[] = {
          rho * dot(v.value, v.rate), contract(stress, rate), -rho * dot(at[body_force], v.value),
          solid_.viscosity * contract(rate, rate), rho * solid_.damping * dot(v.value, v.value)};
      for (int k = 0; k < 5; ++k)
        powers[k] += weight * terms[k];
    });
  }
  void energies(const CellInput& cell, double* energies) const override {
    std::fill(energies, energies + 5, 0.0);
    this->at_points(cell, [&](const auto& at, double weight, int /*q*/, const auto& /*shapes*/) {
      energies[0] += weight * 0.5 * at[density] * dot(at[velocity].value, at[velocity].value);
      energies[1] += weight * strain_energy_density(
                                  solid_.law, green_lagrange(at[displacement].gradient), lame(at));
    });
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  template <class Point>
  auto lame(const Point& at) const {
    using P = std::decay_t<decltype(at[young])>;
    return LameParameters<P>(at[young], solid_.poisson);
  }

  /// dE/dt = sym(F^T grad v), 1/s.
  template <class T>
  static Tensor<T, D> strain_rate(const Tensor<T, D>& F, const Tensor<T, D>& velocity_gradient) {
    Tensor<T, D> rate;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        T sum = 0.0;
        for (int k = 0; k < D; ++k)
          sum += F(k, i) * velocity_gradient(k, j) + F(k, j) * velocity_gradient(k, i);
        rate(i, j) = 0.5 * sum;
      }
    return rate;
  }

  /// Second Piola-Kirchhoff stress at the instant of the equations. At the middle of a step it does
  /// just the work that the energy gains; at its end it is the stress there; between, both in the
  /// proportion that keeps second order.
  template <class Point>
  auto elastic_stress(const Point& at) const {
    using T = typename Point::Number;
    const Tensor<T, D>& now = at[displacement].gradient;
    const auto parameters = lame(at);
    if (at.share == 1) return second_piola(solid_.law, green_lagrange(now), parameters);
    const Tensor<double, D>& accepted = at[displacement].accepted_gradient;
    Tensor<T, D> end;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        end(i, j) = accepted(i, j) + (now(i, j) - accepted(i, j)) / at.share;
    const Tensor<T, D> after = green_lagrange(end);
    Tensor<T, D> stress = mean_stress(solid_.law, green_lagrange(accepted), after, parameters);
    const double of_mean = 2 * (1 - at.share), of_end = 2 * at.share - 1;
    if (of_end == 0) return stress;
    const Tensor<T, D> final = second_piola(solid_.law, after, parameters);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        stress(i, j) = of_mean * stress(i, j) + of_end * final(i, j);
    return stress;
  }

  SolidProperties solid_;
};

}  // namespace hawser
