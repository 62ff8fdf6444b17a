#pragma once
// What the kernels of the flow have in common: the fluid, and where its energy goes (theory.md,
// "Energy").
#include <algorithm>
#include <array>

#include "flow_properties.hpp"
#include "hawser/physics/moving_point_kernel.hpp"

namespace hawser {

/// Derived has, beside what MovingPointKernel asks for, `uses` of velocity, pressure and
/// displacement in this order, and
///   template <class Point> double numerical_power(const Point& at) const;
/// the power per moved volume that its discretisation adds, with the work of the pressure on the
/// divergence, W/m^3.
template <class Derived, int D>
class FlowKernel : public MovingPointKernel<Derived>, public FlowProperties {
 public:
  static constexpr int dimension = D;
  static constexpr std::array<PropertyUse, 4> properties = {
      property::density, property::viscosity, property::eddy_viscosity, property::body_force<D>};
  static constexpr Slot<0> velocity{};
  static constexpr Slot<1> pressure{};
  static constexpr Slot<2> displacement{};
  static constexpr PropertySlot<3> body_force{};

  using MovingPointKernel<Derived>::MovingPointKernel;

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
      double kinetic = 0.5 * rho * dot(v.value, v.value) * expansion;
      double carried = -kinetic, viscous = 0;
      for (int i = 0; i < D; ++i) {
        kinetic += rho * v.value[i] * v.rate[i];
        for (int j = 0; j < D; ++j) {
          carried += rho * v.value[i] * v.gradient(i, j) * c[j];
          viscous += mu * (v.gradient(i, j) + v.gradient(j, i)) * v.gradient(i, j);
        }
      }
      const double terms[] = {kinetic, -rho * dot(v.value, at[body_force]), carried, viscous,
                              static_cast<const Derived&>(*this).numerical_power(at)};
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

 protected:
  /// c = v - w, relative to the mesh, m/s.
  template <class T, class Point>
  static Vector<T, D> convection(const Point& at) {
    Vector<T, D> result;
    for (int i = 0; i < D; ++i)
      result[i] = at[velocity].value[i] - at[displacement].rate[i];
    return result;
  }
};

}  // namespace hawser
