#pragma once
// Loads on the surface of an elastic body (theory.md, equation 6).
#include <array>
#include <cmath>

#include "hawser/physics/moving_frame.hpp"
#include "hawser/physics/place_function.hpp"
#include "hawser/physics/point_kernel.hpp"

namespace hawser {

struct SurfaceLoad {
  Expressions traction;  ///< per reference area, N/m^2; empty: none
  Expressions pressure;  ///< on the moved surface, Pa; empty: none
};

/// A traction keeps its direction, a pressure follows the surface. Both may depend on the moved
/// place.
template <int D>
class SurfaceLoadKernel : public PointKernel<SurfaceLoadKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr bool on_facets = true;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<D>::velocity.as(Role::adds, need::value),
      StandardFields<D>::displacement.as(Role::kinematic, need::value | need::gradient)};
  static constexpr Slot<0> velocity{};
  static constexpr Slot<1> displacement{};

  SurfaceLoadKernel(Domain facets, SurfaceLoad load)
      : PointKernel<SurfaceLoadKernel>(std::move(facets)), load_(std::move(load)) {}

  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    const auto load = outward_load(at);
    for (int i = 0; i < D; ++i)
      out[velocity].source[i] = -load[i];
  }

  std::vector<EnergyTerm> energy_terms() const override {
    return {{"surface load", EnergyTerm::Kind::supplied}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    powers[0] = 0;
    this->at_points(cell, [&](const auto& at, double weight, int /*q*/, const auto& /*shapes*/) {
      powers[0] -= weight * dot(outward_load(at), at[velocity].value);
    });
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  /// Per reference measure of the facet, N.
  template <class Point>
  auto outward_load(const Point& at) const {
    using T = typename Point::Number;
    const Vector<double, D> reference = at.facet();
    const auto here = [&](const Expression& expression) {
      return at_place(expression, at.position, at[displacement].value, at.time);
    };
    Vector<T, D> load;
    if (!load_.traction.empty()) {
      const double area = std::sqrt(dot(reference, reference));
      for (int i = 0; i < D; ++i)
        load[i] = area * here(load_.traction[static_cast<std::size_t>(i)]);
    }
    if (!load_.pressure.empty()) {
      const MovingFrame<T, D> frame(at[displacement].gradient);
      const Vector<T, D> normal = multiply(reference, frame.inverse);  // n dA = J F^-T N dA
      const T pressure = here(load_.pressure[0]);
      for (int i = 0; i < D; ++i)
        load[i] -= pressure * frame.volume * normal[i];
    }
    return load;
  }

  SurfaceLoad load_;
};

}  // namespace hawser
