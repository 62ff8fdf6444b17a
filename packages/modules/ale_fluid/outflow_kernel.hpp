#pragma once
// The traction at an outflow boundary (theory.md, equations 9-10).
#include <array>

#include "hawser/physics/element_kernel.hpp"

namespace hawser {

struct OutflowProperties {
  double pressure = 0;           ///< p0, Pa
  double density = 1000;         ///< kg/m^3
  double viscosity = 1;          ///< dynamic, Pa s
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
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  OutflowKernel(Domain facets, const OutflowProperties& properties)
      : ElementKernel(std::move(facets)), properties_(properties) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    T x[3][2];
    for (int a = 0; a < 3; ++a)
      for (int i = 0; i < 2; ++i)
        x[a][i] = at.coordinate(a, i) + at.value(displacement, a, i);
    // Outward normal times the edge's length; the body lies on the left of 0 -> 1.
    const T normal[2] = {x[1][1] - x[0][1], x[0][0] - x[1][0]};
    const T twice_area = normal[0] * (x[0][0] - x[2][0]) + normal[1] * (x[0][1] - x[2][1]);
    T load[2] = {-properties_.pressure * normal[0], -properties_.pressure * normal[1]};
    if (properties_.keeps_poiseuille) {
      T transposed[2] = {T(0.0), T(0.0)};  // (grad v)^T n
      for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        const T flow = at.value(velocity, a, 0) * normal[0] + at.value(velocity, a, 1) * normal[1];
        transposed[0] += (x[b][1] - x[c][1]) / twice_area * flow;
        transposed[1] += (x[c][0] - x[b][0]) / twice_area * flow;
      }
      for (int i = 0; i < 2; ++i)
        load[i] += properties_.viscosity * transposed[i];
    }
    for (int a = 0; a < 2; ++a) {
      const T flow = at.value(velocity, a, 0) * normal[0] + at.value(velocity, a, 1) * normal[1];
      for (int i = 0; i < 2; ++i) {
        out[at.index(velocity, a, i)] -= 0.5 * load[i];
        if (flow < 0.0)  // nodal quadrature
          out[at.index(velocity, a, i)] -=
              0.5 * properties_.backflow * properties_.density * flow * at.value(velocity, a, i);
      }
    }
  }

  std::vector<EnergyTerm> energy_terms() const override {
    return {{"outflow", EnergyTerm::Kind::transported}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    double residual[unknowns()];
    this->residual(cell, residual);
    powers[0] = 0;
    for (int i = 0; i < 6; ++i)
      powers[0] += residual[i] * cell.fields[velocity].value[i];
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  OutflowProperties properties_;
};

}  // namespace hawser
