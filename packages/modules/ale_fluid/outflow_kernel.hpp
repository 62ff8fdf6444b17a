#pragma once
// The traction at an outflow boundary (theory.md, equations 9-10).
#include <array>

#include "flow_properties.hpp"
#include "hawser/physics/moved_point.hpp"
#include "hawser/physics/point_kernel.hpp"

namespace hawser {

struct OutflowTraction {
  double pressure = 0;           ///< p0, Pa
  bool keeps_poiseuille = true;  ///< t = -p0 n + mu (grad v)^T n, else t = -p0 n
  double backflow = 0;           ///< share of rho (v.n)_- v that resists inflow through the outlet
};

/// On facets, with the velocity gradient of the cell behind; any basis.
template <int D>
class OutflowKernel : public PointKernel<OutflowKernel<D>>, public FlowProperties {
 public:
  static constexpr int dimension = D;
  static constexpr bool on_facets = true;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<D>::velocity.as(Role::adds, need::value | need::gradient),
      StandardFields<D>::displacement.as(Role::reads_if_solved, need::gradient)};
  static constexpr std::array<PropertyUse, 3> properties = {property::density, property::viscosity,
                                                            property::eddy_viscosity};
  static constexpr Slot<0> velocity{};
  static constexpr Slot<1> displacement{};

  OutflowKernel(Domain facets, std::vector<PropertyConstant> constants,
                const OutflowTraction& outside)
      : PointKernel<OutflowKernel>(std::move(facets), std::move(constants)), outside_(outside) {}

  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    const auto frame = detail::frame_at<OutflowKernel>(at);
    out.inverted = frame.inverted();
    if (out.inverted) return;
    const auto load = outward_load(at, frame);
    for (int i = 0; i < D; ++i)
      out[velocity].source[i] = -load[i];
  }

  std::vector<EnergyTerm> energy_terms() const override {
    return {{"outflow", EnergyTerm::Kind::transported}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    powers[0] = 0;
    this->at_points(cell, [&](const auto& at, double weight, int /*q*/, const auto& /*shapes*/) {
      const auto frame = detail::frame_at<OutflowKernel>(at);
      powers[0] -= weight * dot(outward_load(at, frame), at[velocity].value);
    });
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  /// Per reference measure of the facet, N.
  template <class Point, class Frame>
  auto outward_load(const Point& at, const Frame& frame) const {
    using T = typename Point::Number;
    const auto& v = at[velocity].value;
    const Vector<double, D> reference = at.facet();
    Vector<T, D> normal = multiply(reference, frame.inverse);  // n dA = J F^-T N dA
    for (int i = 0; i < D; ++i)
      normal[i] *= frame.volume;
    const T flow = dot(v, normal);
    Vector<T, D> load;
    for (int i = 0; i < D; ++i)
      load[i] = -outside_.pressure * normal[i];
    if (outside_.keeps_poiseuille) {
      const auto mu = total_viscosity(at);
      const Vector<T, D> transposed = multiply(normal, frame.spatial(at[velocity].gradient));
      for (int i = 0; i < D; ++i)
        load[i] += mu * transposed[i];
    }
    if (flow < 0.0)
      for (int i = 0; i < D; ++i)
        load[i] += outside_.backflow * at[density] * flow * v[i];
    return load;
  }

  OutflowTraction outside_;
};

}  // namespace hawser
