#pragma once
// The load of a given current on a slender cable, by drag coefficients (theory.md).
#include <array>
#include <cmath>

#include "axial_kernel.hpp"
#include "hawser/base/constants.hpp"
#include "hawser/physics/place_function.hpp"
#include "load_kernel.hpp"

namespace hawser {

struct DragProperties {
  double normal = 1.2;       ///< Cn: smooth circular cylinder, subcritical
  double tangential = 0.01;  ///< Ct, of the wetted surface
  double added_mass = 1;     ///< Ca, normal, relative to the displaced mass
  double diameter = 0.06;    ///< m
  double density = 1025;     ///< of the water, kg/m^3
};

/// f_n = rho Cn D |u_n| u_n / 2 and f_t = rho Ct pi D |u_t| u_t / 2 of the current relative to the
/// cable, less the added mass times the cable's normal acceleration; per reference length.
template <int D>
class CableDragKernel : public ElementKernel<CableDragKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr CellShape shape = CellShape::line;
  static constexpr int node_count = 2;
  static constexpr std::array<FieldUse, 2> uses = CableKernel<D>::uses;
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  /// `current`: m/s, one expression per direction.
  CableDragKernel(Domain domain, const DragProperties& drag, Expressions current)
      : ElementKernel<CableDragKernel>(std::move(domain)), current_(std::move(current)) {
    normal_ = 0.5 * drag.density * drag.normal * drag.diameter;
    tangential_ = 0.5 * drag.density * drag.tangential * pi * drag.diameter;
    added_mass_ = drag.added_mass * drag.density * pi * drag.diameter * drag.diameter / 4;
  }

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    add_load(at, added_mass_, out);
  }

  std::vector<EnergyTerm> energy_terms() const override {
    return {{"drag", EnergyTerm::Kind::dissipated}, {"added mass", EnergyTerm::Kind::transported}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    double drag[4 * D] = {};
    add_load(this->element(cell), 0, drag);
    powers[0] = 0;
    for (int i = 0; i < 2 * D; ++i)
      powers[0] += drag[i] * cell.fields[velocity].value[i];
    powers[1] = this->residual_times(cell, velocity) - powers[0];
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  template <class Element, class T>
  void add_load(const Element& at, double added_mass, T* out) const {
    using std::sqrt;
    const auto segment = segment_of<T, D>(at, displacement);
    Vector<T, D> tangent = segment.stretch;
    const T stretch = sqrt(dot(tangent, tangent));
    for (int i = 0; i < D; ++i)
      tangent[i] /= stretch;
    for (const GaussPoint& point : three_points) {
      const Vector<T, D> load = load_at(at, point, tangent, added_mass);
      for (int i = 0; i < D; ++i) {
        const T share = point.weight * segment.length * load[i];
        out[at.index(velocity, 0, i)] -= (1 - point.s) * share;
        out[at.index(velocity, 1, i)] -= point.s * share;
      }
    }
  }

  template <class Element, class T>
  Vector<T, D> load_at(const Element& at, const GaussPoint& point, const Vector<T, D>& tangent,
                       double added_mass) const {
    using std::sqrt;
    const PointOnSegment<T, D> place(at, displacement, point);
    Vector<T, D> relative, acceleration;
    for (int i = 0; i < D; ++i) {
      relative[i] = at_place(current_[static_cast<std::size_t>(i)], place.reference,
                             place.displacement, at.time()) -
                    (1 - point.s) * at.value(velocity, 0, i) - point.s * at.value(velocity, 1, i);
      acceleration[i] = (1 - point.s) * at.rate(velocity, 0, i) + point.s * at.rate(velocity, 1, i);
    }
    const T along = dot(relative, tangent);
    const T along_acceleration = dot(acceleration, tangent);
    // |u_n|, protected at zero, where its derivative is infinite: far below any speed that matters.
    constexpr double least_squared = 1e-20;  // m^2/s^2
    T squared = least_squared;
    for (int i = 0; i < D; ++i) {
      relative[i] -= along * tangent[i];
      acceleration[i] -= along_acceleration * tangent[i];
      squared += relative[i] * relative[i];
    }
    const T normal_drag = normal_ * sqrt(squared);
    const T friction = tangential_ * (along < 0.0 ? T(-along * along) : T(along * along));
    Vector<T, D> load;
    for (int i = 0; i < D; ++i)
      load[i] = normal_drag * relative[i] + friction * tangent[i] - added_mass * acceleration[i];
    return load;
  }

  Expressions current_;
  double normal_, tangential_;  // per length: N/(m/s)^2
  double added_mass_;           // per length, kg/m
};

}  // namespace hawser
