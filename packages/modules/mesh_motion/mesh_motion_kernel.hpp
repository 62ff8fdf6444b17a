#pragma once
// The mesh as a linear elastic body whose stiffness grows as its cells shrink (theory.md).
#include <array>
#include <cmath>

#include "hawser/physics/moving_point_kernel.hpp"

namespace hawser {

struct MeshStiffness {
  bool incremental =
      true;          ///< elastic about the last accepted configuration, else about the reference
  double power = 1;  ///< Young's modulus ~ size of the cell^-power
  double poisson = 0.3;
};

/// Force per volume over the local Young's modulus, 1/m.
template <int D>
constexpr PropertyUse mesh_load{"mesh load", "1/m", D, 0.0};

template <int D>
class MeshMotionKernel : public MovingPointKernel<MeshMotionKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr std::array<FieldUse, 1> uses = {
      StandardFields<D>::displacement.as(Role::governs, need::gradient | need::accepted)};
  static constexpr std::array<PropertyUse, 2> properties = {property::mesh_stiffness, mesh_load<D>};
  static constexpr Slot<0> displacement{};
  static constexpr PropertySlot<0> factor{};
  static constexpr PropertySlot<1> load{};

  MeshMotionKernel(Domain domain, const MeshStiffness& stiffness,
                   std::vector<PropertyConstant> constants = {})
      : MovingPointKernel<MeshMotionKernel>(std::move(domain), std::move(constants)),
        stiffness_(stiffness) {}

  /// The configuration about which the mesh is elastic, not the present one.
  template <class Point>
  MovingFrame<double, D> frame(const Point& at) const {
    return MovingFrame<double, D>(base(at));
  }

  template <class Point, class Form>
  void moved_form(const Point& at, Form& out) const {
    using T = typename Point::Number;
    const auto& gradient = at.reference[displacement].gradient;
    const Tensor<double, D> start = base(at.reference);
    Tensor<T, D> increment;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        increment(i, j) = gradient(i, j) - start(i, j);
    const Tensor<T, D> strain = at.frame.spatial(increment);

    // The reference size is 1 m^2 or m^3: a common factor that cancels from the solution.
    const double size =
        at.reference.shape->measure * at.frame.volume / determinant(at.reference.inverse_jacobian);
    using P = std::decay_t<decltype(at[factor])>;
    const P young = at[factor] * std::pow(size, -stiffness_.power);
    const double nu = stiffness_.poisson;
    const P lambda = young * nu / ((1 + nu) * (1 - 2 * nu));
    const P shear = young / (2 * (1 + nu));
    const T volumetric = lambda * trace(strain);
    Tensor<T, D>& stress = out[displacement].flux;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        stress(i, j) = shear * (strain(i, j) + strain(j, i));
    for (int i = 0; i < D; ++i)
      stress(i, i) += volumetric;
    for (int i = 0; i < D; ++i)
      out[displacement].source[i] = -young * at[load][i];
  }

  std::vector<double> sample_amplitudes() const override { return {0.05}; }

 private:
  template <class Point>
  Tensor<double, D> base(const Point& at) const {
    if (stiffness_.incremental) return at[displacement].accepted_gradient;
    return {};
  }

  MeshStiffness stiffness_;
};

}  // namespace hawser
