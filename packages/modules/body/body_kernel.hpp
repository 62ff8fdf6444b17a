#pragma once
// A body at a point: inertia, weight in water, drag and lift of a given current (theory.md).
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "hawser/base/tensor.hpp"
#include "hawser/physics/element_kernel.hpp"
#include "hawser/physics/place_function.hpp"

namespace hawser {

template <int D>
struct Lift {
  Vector<double, D> direction;  ///< unit
  double area = 0;              ///< lift coefficient times area, m^2
};

template <int D>
struct BodyProperties {
  double mass = 0;           ///< kg
  double added_mass = 0;     ///< kg, in all directions
  Vector<double, D> weight;  ///< in water, N
  double density = 1025;     ///< of the water, kg/m^3
  double drag_area = 0;      ///< drag coefficient times area, m^2
  std::vector<Lift<D>> lifts;
  Expressions current;  ///< m/s, per direction; empty: still water
};

/// m a = weight + rho CdA |u| u/2 + rho ClA (|u|^2 e - (e.u) u)/2 - m_a a with the water's velocity
/// u relative to the body and the direction e of a lift.
template <int D>
class BodyKernel : public ElementKernel<BodyKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr CellShape shape = CellShape::point;
  static constexpr int node_count = 1;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<D>::velocity.as(Role::adds, need::value | need::rate),
      StandardFields<D>::displacement.as(Role::reads, need::value)};
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  BodyKernel(Domain points, BodyProperties<D> body)
      : ElementKernel<BodyKernel>(std::move(points)), body_(std::move(body)) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    const Vector<T, D> load = water_load<T>(at);
    for (int i = 0; i < D; ++i)
      out[at.index(velocity, 0, i)] +=
          (body_.mass + body_.added_mass) * at.rate(velocity, 0, i) - body_.weight[i] - load[i];
  }

  std::vector<EnergyTerm> energy_terms() const override {
    using Kind = EnergyTerm::Kind;
    return {{"kinetic", Kind::stored},
            {"weight", Kind::supplied},
            {"drag", Kind::dissipated},
            {"added mass", Kind::transported}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    const auto at = this->element(cell);
    const Vector<double, D> load = water_load<double>(at);
    std::fill(powers, powers + 4, 0.0);
    for (int i = 0; i < D; ++i) {
      const double v = at.value(velocity, 0, i);
      powers[0] += body_.mass * at.rate(velocity, 0, i) * v;
      powers[1] -= body_.weight[i] * v;
      powers[2] -= load[i] * v;
      powers[3] += body_.added_mass * at.rate(velocity, 0, i) * v;
    }
  }
  void energies(const CellInput& cell, double* energies) const override {
    const double* const v = cell.fields[velocity].value;
    energies[0] = 0;
    for (int i = 0; i < D; ++i)
      energies[0] += 0.5 * body_.mass * v[i] * v[i];
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  /// Drag and lift, N.
  template <class T, class Element>
  Vector<T, D> water_load(const Element& at) const {
    using std::sqrt;
    // Protects |u| at zero, where its derivative is infinite: far below any speed that matters.
    constexpr double least_squared = 1e-20;  // m^2/s^2
    Vector<double, D> reference;
    Vector<T, D> moved, relative, load;
    for (int i = 0; i < D; ++i) {
      reference[i] = at.coordinate(0, i);
      moved[i] = at.value(displacement, 0, i);
    }
    T squared = least_squared;
    for (int i = 0; i < D; ++i) {
      relative[i] = -at.value(velocity, 0, i);
      if (!body_.current.empty())
        relative[i] +=
            at_place(body_.current[static_cast<std::size_t>(i)], reference, moved, at.time());
      squared += relative[i] * relative[i];
    }
    const T drag = 0.5 * body_.density * body_.drag_area * sqrt(squared);
    for (int i = 0; i < D; ++i)
      load[i] = drag * relative[i];
    for (const Lift<D>& lift : body_.lifts) {
      T along = 0.0;
      for (int i = 0; i < D; ++i)
        along += lift.direction[i] * relative[i];
      for (int i = 0; i < D; ++i)
        load[i] +=
            0.5 * body_.density * lift.area * (squared * lift.direction[i] - along * relative[i]);
    }
    return load;
  }

  BodyProperties<D> body_;
};

}  // namespace hawser
