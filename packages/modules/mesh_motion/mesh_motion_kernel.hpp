#pragma once
// The mesh as a linear elastic body whose stiffness grows as its cells shrink (theory.md).
#include <array>
#include <cmath>

#include "hawser/physics/moving_frame.hpp"
#include "hawser/physics/place_function.hpp"
#include "hawser/physics/point_kernel.hpp"

namespace hawser {

struct MeshStiffness {
  bool incremental =
      true;          ///< elastic about the last accepted configuration, else about the reference
  double power = 1;  ///< Young's modulus ~ area^-power
  double poisson = 0.3;
};

struct NoLoad {
  static constexpr unsigned displacement_needs = 0;
};

/// Force per volume over the local Young's modulus, 1/m.
struct MeshLoad {
  static constexpr unsigned displacement_needs = need::value;
  Expressions components;
};

template <class Load>
class MeshMotionKernel : public PointKernel<MeshMotionKernel<Load>> {
 public:
  static constexpr int dimension = 2;
  static constexpr std::array<FieldUse, 1> uses = {StandardFields<2>::displacement.as(
      Role::governs, need::gradient | need::accepted | Load::displacement_needs)};
  static constexpr Slot<0> displacement{};

  MeshMotionKernel(Domain domain, const MeshStiffness& stiffness, Load load)
      : PointKernel<MeshMotionKernel>(std::move(domain)),
        stiffness_(stiffness),
        load_(std::move(load)) {}

  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    using T = typename Point::Number;
    constexpr int D = dimension;
    const auto& d = at[displacement];
    Tensor<double, D> base;  // grad of the configuration about which the mesh is elastic
    if (stiffness_.incremental) base = d.accepted_gradient;
    const MovingFrame<double, D> frame(base);
    out.inverted = frame.inverted();
    if (out.inverted) return;

    Tensor<T, D> increment;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        increment(i, j) = d.gradient(i, j) - base(i, j);
    const Tensor<T, D> strain = multiply(increment, frame.inverse);

    // The reference area is 1 m^2: a common factor that cancels from the solution.
    const double area = 0.5 * frame.volume / determinant(at.inverse_jacobian);
    const double young = std::pow(area, -stiffness_.power);
    const double nu = stiffness_.poisson;
    const double lambda = young * nu / ((1 + nu) * (1 - 2 * nu));
    const double shear = young / (2 * (1 + nu));
    const T volumetric = lambda * trace(strain);
    Tensor<T, D> stress;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        stress(i, j) = shear * (strain(i, j) + strain(j, i));
    for (int i = 0; i < D; ++i)
      stress(i, i) += volumetric;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        T sum = stress(i, 0) * frame.inverse(j, 0);
        for (int k = 1; k < D; ++k)
          sum += stress(i, k) * frame.inverse(j, k);
        out[displacement].flux(i, j) = frame.volume * sum;
      }
    if constexpr (Load::displacement_needs != 0)
      for (int i = 0; i < D; ++i)
        out[displacement].source[i] =
            -frame.volume * young *
            at_place(load_.components[static_cast<std::size_t>(i)], at.position, d.value, at.time);
  }

  std::vector<double> sample_amplitudes() const override { return {0.05}; }

 private:
  MeshStiffness stiffness_;
  Load load_;
};

}  // namespace hawser
