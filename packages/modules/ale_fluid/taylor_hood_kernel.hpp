#pragma once
// Incompressible Navier-Stokes flow on a moving mesh by Taylor and Hood's elements, at a quadrature
// point (theory.md, "Taylor-Hood").
#include <array>

#include "flow_kernel.hpp"

namespace hawser {

/// Quadratic velocity and linear pressure, which are stable by themselves: Galerkin's equations,
/// and `grad_div` (Pa s) times the divergences of velocity and test function, which is zero in the
/// continuous problem.
template <int D>
class TaylorHoodKernel : public FlowKernel<TaylorHoodKernel<D>, D> {
 public:
  static constexpr std::array<FieldUse, 3> uses = {
      StandardFields<D>::velocity.only(Basis::p2).as(Role::adds,
                                                     need::value | need::rate | need::gradient),
      StandardFields<D>::pressure.only(Basis::p1).as(Role::adds, need::value),
      StandardFields<D>::displacement.as(Role::reads_if_solved, need::rate | need::gradient)};
  using Base = FlowKernel<TaylorHoodKernel, D>;
  using Base::velocity, Base::pressure, Base::body_force, Base::density;

  TaylorHoodKernel(Domain domain, std::vector<PropertyConstant> constants, double grad_div)
      : Base(std::move(domain), std::move(constants)), grad_div_(grad_div) {}

  template <class Point, class Form>
  void moved_form(const Point& at, Form& out) const {
    using T = typename Point::Number;
    const auto& rho = at[density];
    const auto mu = Base::total_viscosity(at);
    const auto v = at[velocity];
    const Vector<T, D> convected = multiply(v.gradient, Base::template convection<T>(at));
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

  template <class Point>
  double numerical_power(const Point& at) const {
    const double divergence = trace(at[velocity].gradient);
    return (grad_div_ * divergence - at[pressure].value) * divergence;
  }

 private:
  double grad_div_;
};

}  // namespace hawser
