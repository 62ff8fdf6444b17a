#pragma once
// Incompressible Navier-Stokes flow on a moving mesh, at a quadrature point (theory.md, equations
// 1-8).
#include <algorithm>
#include <array>

#include "flow_properties.hpp"
#include "hawser/physics/cell_metric.hpp"
#include "hawser/physics/moving_point_kernel.hpp"

namespace hawser {

/// Linear velocity and pressure with residual-based SUPG, PSPG and LSIC stabilisation, time scales
/// from the metric of the moved element (Bazilevs et al., Comput. Methods Appl. Mech. Engrg. 197
/// (2007) 173-201). Density, viscosity and body force are properties: whatever supplies them is
/// felt by the stress and by the stabilisation alike.
template <int D>
class FluidKernel : public MovingPointKernel<FluidKernel<D>>, public FlowProperties {
 public:
  static constexpr int dimension = D;
  static constexpr int memory = D;  // the subscale velocity, m/s
  static constexpr std::array<FieldUse, 3> uses = {
      StandardFields<D>::velocity.only(Basis::p1).as(Role::adds,
                                                     need::value | need::rate | need::gradient),
      StandardFields<D>::pressure.only(Basis::p1).as(Role::adds, need::value | need::gradient),
      StandardFields<D>::displacement.as(Role::reads_if_solved, need::rate | need::gradient)};
  static constexpr std::array<PropertyUse, 4> properties = {
      property::density, property::viscosity, property::eddy_viscosity, property::body_force<D>};
  static constexpr Slot<0> velocity{};
  static constexpr Slot<1> pressure{};
  static constexpr Slot<2> displacement{};
  static constexpr PropertySlot<3> body_force{};

  using MovingPointKernel<FluidKernel>::MovingPointKernel;

  template <class Point, class Form>
  void moved_form(const Point& at, Form& out) const {
    using T = typename Point::Number;
    const auto& rho = at[density];
    const auto mu = total_viscosity(at);
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

  std::vector<EnergyTerm> energy_terms() const override {
    using Kind = EnergyTerm::Kind;
    return {{"flow kinetic", Kind::stored},
            {"body force", Kind::supplied},
            {"flow", Kind::transported},
            {"viscosity", Kind::dissipated},
            {"stabilisation", Kind::numerical}};
  }
  /// theory.md, "Energy". What the pressure does on a divergence that the subscales leave belongs
  /// to the stabilisation.
  void powers(const CellInput& cell, double* powers) const override {
    std::fill(powers, powers + 5, 0.0);
    this->at_moved_points(cell, [&](const auto& at, double weight, double expansion) {
      const double rho = at[density];
      const double mu = total_viscosity(at);
      const auto v = at[velocity];
      const Balance<double> balance = balance_at<double>(at);
      const double divergence = trace(v.gradient);
      double kinetic = 0.5 * rho * dot(v.value, v.value) * expansion;
      double force = 0, carried = -kinetic, viscous = 0;
      double numerical =
          (rho * balance.continuity_scale * divergence - at[pressure].value) * divergence;
      for (int i = 0; i < D; ++i) {
        kinetic += rho * v.value[i] * v.rate[i];
        force -= rho * v.value[i] * at[body_force][i];
        numerical += rho * v.value[i] * balance.subscale_rate[i];
        for (int j = 0; j < D; ++j) {
          carried += rho * v.value[i] * v.gradient(i, j) * balance.convection[j];
          viscous += mu * (v.gradient(i, j) + v.gradient(j, i)) * v.gradient(i, j);
          numerical -= rho * balance.subscale[i] * balance.convection[j] * v.gradient(i, j);
        }
      }
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
    const auto d = at[displacement];
    Balance<T> result;
    for (int i = 0; i < D; ++i)
      result.convection[i] = v.value[i] - d.rate[i];
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
