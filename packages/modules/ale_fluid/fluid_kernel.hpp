#pragma once
// Incompressible Navier-Stokes flow on a moving mesh, at a quadrature point (theory.md, equations
// 1-8).
#include <array>

#include "hawser/physics/moving_frame.hpp"
#include "hawser/physics/place_function.hpp"
#include "hawser/physics/point_kernel.hpp"

namespace hawser {

struct FluidProperties {
  double density = 1000;  ///< kg/m^3
  double viscosity = 1;   ///< dynamic, Pa s
};

/// The same force per mass everywhere, m/s^2.
struct UniformForce {
  static constexpr unsigned displacement_needs = 0;
  double value[2] = {0, 0};
  template <class Point, class Displacement>
  double operator()(int i, const Point& /*at*/, const Displacement& /*d*/) const {
    return value[i];
  }
};

/// A force per mass that varies with the place. Only here does the displacement's value cost
/// derivative directions.
struct VaryingForce {
  static constexpr unsigned displacement_needs = need::value;
  Expressions components;
  template <class Point, class Displacement>
  auto operator()(int i, const Point& at, const Displacement& d) const {
    return at_place(components[static_cast<std::size_t>(i)], at.position, d.value, at.time);
  }
};

/// Linear velocity and pressure with residual-based SUPG, PSPG and LSIC stabilisation, time scales
/// from the metric of the moved element (Bazilevs et al., Comput. Methods Appl. Mech. Engrg. 197
/// (2007) 173-201).
template <class Force>
class FluidKernel : public PointKernel<FluidKernel<Force>> {
 public:
  static constexpr int dimension = 2;
  static constexpr std::array<FieldUse, 3> uses = {
      StandardFields<2>::velocity.as(Role::adds, need::value | need::rate | need::gradient),
      StandardFields<2>::pressure.as(Role::adds, need::value | need::gradient),
      StandardFields<2>::displacement.as(Role::reads,
                                         need::rate | need::gradient | Force::displacement_needs)};
  static constexpr Slot<0> velocity{};
  static constexpr Slot<1> pressure{};
  static constexpr Slot<2> displacement{};

  FluidKernel(Domain domain, const FluidProperties& properties, Force force)
      : PointKernel<FluidKernel>(std::move(domain)),
        properties_(properties),
        force_(std::move(force)) {}

  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    using T = typename Point::Number;
    constexpr int D = dimension;
    const double rho = properties_.density;
    const double mu = properties_.viscosity;
    const MovingFrame<T, D> frame(at[displacement].gradient);
    out.inverted = frame.inverted();
    if (out.inverted) return;

    const auto& v = at[velocity];
    const auto& p = at[pressure];
    const Tensor<T, D> grad_v = frame.spatial(v.gradient);
    const Vector<T, D> grad_p = frame.spatial(p.gradient);
    Vector<T, D> convection;  // c = v - w, relative to the mesh
    for (int i = 0; i < D; ++i)
      convection[i] = v.value[i] - at[displacement].rate[i];
    const Vector<T, D> convected = multiply(grad_v, convection);
    Vector<T, D> inertia;  // rho (dv/dt + c . grad v - b)
    for (int i = 0; i < D; ++i)
      inertia[i] = rho * (v.rate[i] + convected[i] - force_(i, at, at[displacement]));
    const T divergence = trace(grad_v);

    const Scales<T> tau = time_scales<T>(at, frame, convection);
    Vector<T, D>
        subscale;  // tau_M times the strong residual; the viscous term vanishes for linear shapes
    for (int i = 0; i < D; ++i)
      subscale[i] = tau.momentum * (inertia[i] + grad_p[i]);
    const T mean_stress = rho * tau.continuity * divergence - p.value;

    Tensor<T, D> stress;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        stress(i, j) = mu * (grad_v(i, j) + grad_v(j, i)) + subscale[i] * convection[j];
    for (int i = 0; i < D; ++i)
      stress(i, i) += mean_stress;

    for (int i = 0; i < D; ++i)
      out[velocity].source[i] = frame.volume * inertia[i];
    out[velocity].flux = frame.pull_back(stress);
    out[pressure].source = frame.volume * divergence;
    Vector<T, D> stabilised;
    for (int i = 0; i < D; ++i)
      stabilised[i] = subscale[i] / rho;
    out[pressure].flux = frame.pull_back(stabilised);
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 100.0, 0.05}; }

 private:
  template <class T>
  struct Scales {
    T momentum;    ///< s
    T continuity;  ///< m^2/s
  };

  /// tau_M = (4/dt^2 + c.G c + C nu^2 G:G)^-1/2,  tau_C = w (c.G c + C nu^2 G:G)^1/2 / tr G.
  /// G is the metric of the moved cell, 4/h^2 for an equilateral one of edge h: it is taken from
  /// the regular simplex, so that the numbering of a cell's vertices does not matter. The step
  /// stays out of tau_C: short steps would lock the volume of the cells at a sharp edge and raise
  /// the drag.
  template <class T, class Point>
  Scales<T> time_scales(const Point& at, const MovingFrame<T, dimension>& frame,
                        const Vector<T, dimension>& convection) const {
    constexpr int D = dimension;
    constexpr double inverse_estimate = 36.0;  // of linear shapes on simplices
    // A quarter of the customary weight: at a sharp edge the full one adds 10 % drag on coarse
    // cells.
    constexpr double continuity_weight = 0.25;
    const double nu = properties_.viscosity / properties_.density;
    const Tensor<T, D> to_cell = multiply_constant(at.inverse_jacobian, frame.inverse);
    T metric_squared = 0.0;
    Tensor<T, D>
        metric;  // of the regular simplex of edge 2: sum_kl 2 (1 + delta_kl) dxi_k/dx dxi_l/dx
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
        metric_squared += (i == j ? 1.0 : 2.0) * metric(i, j) * metric(i, j);
      }
    const Vector<T, D> metric_c = multiply(metric, convection);
    const T steady = dot(convection, metric_c) + inverse_estimate * nu * nu * metric_squared;
    using std::sqrt;
    Scales<T> scales;
    scales.momentum = 1.0 / sqrt(4.0 / (at.step * at.step) + steady);
    scales.continuity = continuity_weight * sqrt(steady) / trace(metric);
    return scales;
  }

  template <class T>
  static Tensor<T, dimension> multiply_constant(const Tensor<double, dimension>& a,
                                                const Tensor<T, dimension>& b) {
    Tensor<T, dimension> result;
    for (int i = 0; i < dimension; ++i)
      for (int j = 0; j < dimension; ++j) {
        result(i, j) = a(i, 0) * b(0, j);
        for (int k = 1; k < dimension; ++k)
          result(i, j) += a(i, k) * b(k, j);
      }
    return result;
  }

  FluidProperties properties_;
  Force force_;
};

}  // namespace hawser
