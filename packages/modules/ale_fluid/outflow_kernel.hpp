#pragma once
// The traction at an outflow boundary (theory.md, equations 9-10).
#include <array>

#include "hawser/physics/element_kernel.hpp"

namespace hawser {

struct OutflowTraction {
  double pressure = 0;           ///< p0, Pa
  bool keeps_poiseuille = true;  ///< t = -p0 n + mu (grad v)^T n, else t = -p0 n
  double backflow = 0;           ///< share of rho (v.n)_- v that resists inflow through the outlet
};

/// On "facet" cells: the boundary edge's two nodes, then the third node of its triangle, so that
/// the velocity gradient on the boundary is that of the adjacent cell.
class OutflowKernel : public ElementKernel<OutflowKernel> {
 public:
  static constexpr int dimension = 2;
  static constexpr CellShape shape = CellShape::triangle;
  static constexpr int node_count = 3;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<2>::velocity.as(Role::adds, need::value),
      StandardFields<2>::displacement.as(Role::reads_if_solved, need::value)};
  static constexpr std::array<PropertyUse, 3> properties = {property::density, property::viscosity,
                                                            property::eddy_viscosity};
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;
  static constexpr PropertySlot<0> density{};
  static constexpr PropertySlot<1> viscosity{};
  static constexpr PropertySlot<2> eddy_viscosity{};

  OutflowKernel(Domain facets, std::vector<PropertyConstant> constants,
                const OutflowTraction& outside)
      : ElementKernel(std::move(facets), std::move(constants)), outside_(outside) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    T x[3][2];
    for (int a = 0; a < 3; ++a)
      for (int i = 0; i < 2; ++i)
        x[a][i] = at.coordinate(a, i) + at.value(displacement, a, i);
    // Outward normal times the edge's length; the body lies on the left of 0 -> 1.
    const T normal[2] = {x[1][1] - x[0][1], x[0][0] - x[1][0]};
    const T twice_area = normal[0] * (x[0][0] - x[2][0]) + normal[1] * (x[0][1] - x[2][1]);
    T transposed[2] = {T(0.0), T(0.0)};  // (grad v)^T n
    if (outside_.keeps_poiseuille)
      for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        const T flow = at.value(velocity, a, 0) * normal[0] + at.value(velocity, a, 1) * normal[1];
        transposed[0] += (x[b][1] - x[c][1]) / twice_area * flow;
        transposed[1] += (x[c][0] - x[b][0]) / twice_area * flow;
      }
    for (int a = 0; a < 2; ++a) {
      const T flow = at.value(velocity, a, 0) * normal[0] + at.value(velocity, a, 1) * normal[1];
      const auto& rho = at.property(density, a);
      for (int i = 0; i < 2; ++i) {  // nodal quadrature
        const T load =
            (at.property(viscosity, a) + rho * at.property(eddy_viscosity, a)) * transposed[i] -
            outside_.pressure * normal[i];
        out[at.index(velocity, a, i)] -= 0.5 * load;
        if (flow < 0.0)
          out[at.index(velocity, a, i)] -=
              0.5 * outside_.backflow * rho * flow * at.value(velocity, a, i);
      }
    }
  }

  std::vector<EnergyTerm> energy_terms() const override {
    return {{"outflow", EnergyTerm::Kind::transported}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    powers[0] = residual_times(cell, velocity);
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  OutflowTraction outside_;
};

}  // namespace hawser
