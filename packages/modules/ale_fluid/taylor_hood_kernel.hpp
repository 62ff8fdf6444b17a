#pragma once
// Incompressible Navier-Stokes flow on a moving mesh by Taylor and Hood's elements, at a quadrature
// point (theory.md, "Taylor-Hood").
#include <algorithm>
#include <array>

#include "flow_properties.hpp"
#include "hawser/physics/moving_point_kernel.hpp"

namespace hawser {

/// Quadratic velocity and linear pressure, which are stable by themselves: Galerkin's equations,
/// and `grad_div` (Pa s) times the divergences of velocity and test function, which is zero in the
/// continuous problem.
template <int D>
class TaylorHoodKernel : public MovingPointKernel<TaylorHoodKernel<D>>, public FlowProperties {
 public:
  static constexpr int dimension = D;
  static constexpr std::array<FieldUse, 3> uses = {
      StandardFields<D>::velocity.only(Basis::p2).as(Role::adds,
                                                     need::value | need::rate | need::gradient),
      StandardFields<D>::pressure.only(Basis::p1).as(Role::adds, need::value),
      StandardFields<D>::displacement.as(Role::reads_if_solved, need::rate | need::gradient)};
  static constexpr std::array<PropertyUse, 4> properties = {
      property::density, property::viscosity, property::eddy_viscosity, property::body_force<D>};
  static constexpr Slot<0> velocity{};
  static constexpr Slot<1> pressure{};
  static constexpr Slot<2> displacement{};
  static constexpr PropertySlot<3> body_force{};

  TaylorHoodKernel(Domain domain, std::vector<PropertyConstant> constants, double grad_div)
      : MovingPointKernel<TaylorHoodKernel>(std::move(domain), std::move(constants)),
        grad_div_(grad_div) {}

  template <class Point, class Form>
  void moved_form(const Point& at, Form& out) const {
    using T = typename Point::Number;
    const auto& rho = at[density];
    const auto mu = total_viscosity(at);
    const auto v = at[velocity];
    const Vector<T, D> convected = multiply(v.gradient, convection<T>(at));
    const T divergence = trace(v.gradient);
    const T mean_stress = grad_div_ * divergence - at[pressure].value;
    for (int i = 0; i < D; ++i) {
      out[velocity].source[i] = rho * (v.rate[i] + convected[i] - at[body_force][i]);
      for (int j = 0; j < D; ++j)
        out[velocity].flux(i, j) = mu * (v.gradient(i, j) + v.gradient(j, i));
      out[velocity].flux(i, i) += mean_stress;
    }
    out[pressure].source = divergence;
  }

  std::vector<EnergyTerm> energy_terms() const override {
    using Kind = EnergyTerm::Kind;
    return {{"flow kinetic", Kind::stored},
            {"body force", Kind::supplied},
            {"flow", Kind::transported},
            {"viscosity", Kind::dissipated},
            {"stabilisation", Kind::numerical}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    std::fill(powers, powers + 5, 0.0);
    this->at_moved_points(cell, [&](const auto& at, double weight, double expansion) {
      const double rho = at[density];
      const double mu = total_viscosity(at);
      const auto v = at[velocity];
      const Vector<double, D> c = convection<double>(at);
      const double divergence = trace(v.gradient);
      double kinetic = 0.5 * rho * dot(v.value, v.value) * expansion;
      double force = 0, carried = -kinetic, viscous = 0;
      for (int i = 0; i < D; ++i) {
        kinetic += rho * v.value[i] * v.rate[i];
        force -= rho * v.value[i] * at[body_force][i];
        for (int j = 0; j < D; ++j) {
          carried += rho * v.value[i] * v.gradient(i, j) * c[j];
          viscous += mu * (v.gradient(i, j) + v.gradient(j, i)) * v.gradient(i, j);
        }
      }
      const double numerical = (grad_div_ * divergence - at[pressure].value) * divergence;
      const double terms[] = {kinetic, force, carried, viscous, numerical};
      for (int k = 0; k < 5; ++k)
        powers[k] += weight * terms[k];
    });
  }
  void energies(const CellInput& cell, double* energies) const override {
    std::fill(energies, energies + 5, 0.0);
    this->at_moved_points(cell, [&](const auto& at, double weight, double /*expansion*/) {
      energies[0] += weight * 0.5 * at[density] * dot(at[velocity].value, at[velocity].value);
    });
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 100.0, 0.05}; }

 private:
  /// c = v - w, relative to the mesh, m/s.
  template <class T, class Point>
  static Vector<T, D> convection(const Point& at) {
    Vector<T, D> result;
    for (int i = 0; i < D; ++i)
      result[i] = at[velocity].value[i] - at[displacement].rate[i];
    return result;
  }

  double grad_div_;
};

}  // namespace hawser
