#pragma once
// Incompressible Navier-Stokes flow on a moving mesh, at a quadrature point (theory.md, equations
// 1-8).
#include <array>

#include "flow_kernel.hpp"
#include "hawser/physics/cell_metric.hpp"

namespace hawser {

/// Linear velocity and pressure with residual-based SUPG, PSPG and LSIC stabilisation, time scales
/// from the metric of the moved element (Bazilevs et al., Comput. Methods Appl. Mech. Engrg. 197
/// (2007) 173-201). Density, viscosity and body force are properties: whatever supplies them is
/// felt by the stress and by the stabilisation alike.
template <int D>
class FluidKernel : public FlowKernel<FluidKernel<D>, D> {
 public:
  static constexpr int memory = D;  // the subscale velocity, m/s
  static constexpr std::array<FieldUse, 3> uses = {
      StandardFields<D>::velocity.only(Basis::p1).as(Role::adds,
                                                     need::value | need::rate | need::gradient),
      StandardFields<D>::pressure.only(Basis::p1).as(Role::adds, need::value | need::gradient),
      StandardFields<D>::displacement.as(Role::reads_if_solved, need::rate | need::gradient)};
  using Base = FlowKernel<FluidKernel, D>;
  using Base::Base;
  using Base::velocity, Base::pressure, Base::body_force, Base::density, Base::viscosity,
      Base::eddy_viscosity;

  template <class Point, class Form>
  void moved_form(const Point& at, Form& out) const {
    using T = typename Point::Number;
    const auto& rho = at[density];
    const auto mu = Base::total_viscosity(at);
    const auto v = at[velocity];
    const Balance<T> balance = balance_at<T>(at);
    const T mean_stress = rho * balance.continuity_scale * trace(v.gradient) - at[pressure].value;

    Tensor<T, D> stress;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        stress(i, j) = mu * (v.gradient(i, j) + v.gradient(j, i)) -
                       rho * balance.subscale[i] * balance.convection[j];
    for (int i = 0; i < D; ++i)
      stress(i, i) += mean_stress;

    for (int i = 0; i < D; ++i)
      out[velocity].source[i] = balance.inertia[i] + rho * balance.subscale_rate[i];
    out[velocity].flux = stress;
    out[pressure].source = trace(v.gradient);
    for (int i = 0; i < D; ++i)
      out[pressure].flux[i] = -balance.subscale[i];
  }

  template <class Point>
  void moved_advance(const Point& at, double* next) const {
    const Balance<double> balance = balance_at<double>(at);
    for (int i = 0; i < D; ++i)
      next[i] = balance.subscale[i];
  }

  /// What the pressure does on a divergence that the subscales leave belongs to the stabilisation.
  template <class Point>
  double numerical_power(const Point& at) const {
    const double rho = at[density];
    const auto v = at[velocity];
    const Balance<double> balance = balance_at<double>(at);
    const double divergence = trace(v.gradient);
    const Vector<double, D> convected = multiply(v.gradient, balance.convection);
    return (rho * balance.continuity_scale * divergence - at[pressure].value) * divergence +
           rho * (dot(v.value, balance.subscale_rate) - dot(balance.subscale, convected));
  }

 private:
  template <class T>
  struct Balance {
    Vector<T, D> convection;     ///< c = v - w, relative to the mesh, m/s
    Vector<T, D> inertia;        ///< rho (dv/dt + c . grad v - b), N/m^3
    Vector<T, D> subscale;       ///< v', m/s
    Vector<T, D> subscale_rate;  ///< m/s^2
    T continuity_scale;          ///< tau_C, m^2/s
  };

  /// rho dv'/dt + rho v'/tau_M = -R, by implicit Euler from the instant of the last equations. The
  /// viscous part of the strong residual R vanishes for linear shapes.
  template <class T, class Point>
  Balance<T> balance_at(const Point& at) const {
    const auto& rho = at[density];
    const auto v = at[velocity];
    const auto p = at[pressure];
    Balance<T> result;
    result.convection = Base::template convection<T>(at);
    const Vector<T, D> convected = multiply(v.gradient, result.convection);
    const Scales<T> tau = time_scales<T>(at, result.convection);
    result.continuity_scale = tau.continuity;
    const double per_step = 1 / at.elapsed;  // 0 in a steady solve
    const T effective = 1.0 / (per_step + 1.0 / tau.momentum);
    for (int i = 0; i < D; ++i) {
      result.inertia[i] = rho * (v.rate[i] + convected[i] - at[body_force][i]);
      const T strong_residual = result.inertia[i] + p.gradient[i];
      result.subscale[i] = effective * (per_step * at.memory[i] - strong_residual / rho);
      result.subscale_rate[i] = per_step * (result.subscale[i] - at.memory[i]);
    }
    return result;
  }

  template <class T>
  struct Scales {
    T momentum;    ///< s
    T continuity;  ///< m^2/s
  };

  /// tau_M = (c.G c + C nu^2 G:G)^-1/2 (subscale_rate),  tau_C = w / (tau_M tr G).
  /// G is the metric of the moved cell, 4/h^2 for an equilateral one or a square of edge h. The
  /// step stays out of both: the subscale has a rate of its own, and in tau_C short steps would
  /// lock the volume of the cells at a sharp edge and raise the drag.
  template <class T, class Point>
  Scales<T> time_scales(const Point& at, const Vector<T, D>& convection) const {
    // A quarter of the customary weight: at a sharp edge the full one adds 10 % drag on coarse
    // cells.
    constexpr double continuity_weight = 0.25;
    using P = std::decay_t<decltype(at[viscosity])>;
    const P nu = at[viscosity] / at[density] + at[eddy_viscosity];
    const Tensor<T, D> metric = cell_metric(at);
    const T rate = subscale_rate(metric, convection, nu);
    Scales<T> scales;
    scales.momentum = 1.0 / rate;
    scales.continuity = continuity_weight * rate / trace(metric);
    return scales;
  }
};

}  // namespace hawser
