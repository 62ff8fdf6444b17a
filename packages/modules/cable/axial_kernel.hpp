#pragma once
// Line elements of a slender cable in the velocity's own basis (theory.md).
#include <array>
#include <cmath>

#include "hawser/base/tensor.hpp"
#include "hawser/physics/element_kernel.hpp"
#include "tension.hpp"

namespace hawser {

/// A segment and its deformation.
template <class T, int D>
struct Segment {
  double length = 0;     ///< of the reference, m
  T strain = 0.0;        ///< Green-Lagrange, E = (|x'|^2 - 1)/2
  Vector<T, D> stretch;  ///< x' = dx/dS

  /// From X(node, component) and d(node, component).
  template <class Reference, class Displacement>
  Segment(Reference&& X, Displacement&& d) {
    for (int i = 0; i < D; ++i)
      length += (X(1, i) - X(0, i)) * (X(1, i) - X(0, i));
    length = std::sqrt(length);
    // E from the displacement alone: 1 is never subtracted from |x'|^2, which would cost digits.
    for (int i = 0; i < D; ++i) {
      const double direction = (X(1, i) - X(0, i)) / length;
      const T slope = (d(1, i) - d(0, i)) / length;
      stretch[i] = direction + slope;
      strain += slope * (direction + 0.5 * slope);
    }
  }
};

/// Of the segment that an element kernel works on.
template <class T, int D, class Element>
Segment<T, D> segment_of(const Element& at, int displacement) {
  return {[&](int a, int i) { return at.coordinate(a, i); },
          [&](int a, int i) { return at.value(displacement, a, i); }};
}

/// Of the same at the end of the step, and at its start.
template <class T, int D, class Element>
T strain_at_end(const Element& at, int displacement) {
  return Segment<T, D>([&](int a, int i) { return at.coordinate(a, i); },
                       [&](int a, int i) { return at.end(displacement, a, i); })
      .strain;
}
template <int D, class Element>
double strain_before(const Element& at, int displacement) {
  return Segment<double, D>([&](int a, int i) { return at.coordinate(a, i); },
                            [&](int a, int i) { return at.accepted(displacement, a, i); })
      .strain;
}

/// Inertia, damping, membrane force and weight.
template <int D>
class CableKernel : public ElementKernel<CableKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr CellShape shape = CellShape::line;
  static constexpr int node_count = 2;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<D>::velocity.as(Role::adds, need::value | need::rate),
      StandardFields<D>::displacement.as(Role::kinematic, need::value | need::accepted)};
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  /// `weight`: N per reference length.
  CableKernel(Domain domain, const CableProperties& cable, const Vector<double, D>& weight)
      : ElementKernel<CableKernel>(std::move(domain)), cable_(cable), weight_(weight) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    const auto segment = segment_of<T, D>(at, displacement);
    const T tension = elastic_tension<T>(at) + cable_.axial_damping * strain_rate<T>(at, segment);
    for (int i = 0; i < D; ++i) {
      const T force = tension * segment.stretch[i];
      out[at.index(velocity, 0, i)] -= force;
      out[at.index(velocity, 1, i)] += force;
      T load[2];
      for (int a = 0; a < 2; ++a)
        load[a] = cable_.mass * at.rate(velocity, a, i) +
                  cable_.damping * at.value(velocity, a, i) - weight_[i];
      out[at.index(velocity, 0, i)] += segment.length / 6 * (2.0 * load[0] + load[1]);
      out[at.index(velocity, 1, i)] += segment.length / 6 * (load[0] + 2.0 * load[1]);
    }
  }

  bool switches() const override { return true; }
  bool on_held_branch(const CellInput& cell) const override {
    const auto at = this->element(cell);
    return !taut(strain_before<D>(at, displacement)) ||
           taut(strain_at_end<double, D>(at, displacement));
  }

  std::vector<Kernel::Quantity> quantities() const override { return {{"tension", "N", true}}; }
  /// The true tension, stretch times second Piola tension.
  void evaluate(const CellInput& cell, double* values) const override {
    const Segment<double, D> segment(
        [&](int a, int i) { return cell.coordinates[a * D + i]; },
        [&](int a, int i) { return cell.fields[displacement].value[a * D + i]; });
    values[0] = std::sqrt(1 + 2 * segment.strain) * slack_tension(segment.strain, cable_);
  }

  std::vector<EnergyTerm> energy_terms() const override {
    using Kind = EnergyTerm::Kind;
    return {{"kinetic", Kind::stored},
            {"axial strain", Kind::stored},
            {"weight", Kind::supplied},
            {"internal damping", Kind::dissipated},
            {"external damping", Kind::dissipated}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    const auto at = this->element(cell);
    const auto segment = segment_of<double, D>(at, displacement);
    const double rate = strain_rate<double>(at, segment);
    const FieldOnCell& v = cell.fields[velocity];
    powers[0] = cable_.mass * lengthwise(segment.length, v.value, v.rate);
    powers[1] = segment.length * elastic_tension<double>(at) * rate;
    powers[2] = 0;
    for (int i = 0; i < D; ++i)
      powers[2] -= 0.5 * segment.length * weight_[i] * (v.value[i] + v.value[D + i]);
    powers[3] = segment.length * cable_.axial_damping * rate * rate;
    powers[4] = cable_.damping * lengthwise(segment.length, v.value, v.value);
  }
  void energies(const CellInput& cell, double* energies) const override {
    const auto segment = segment_of<double, D>(this->element(cell), displacement);
    const double* const v = cell.fields[velocity].value;
    energies[0] = 0.5 * cable_.mass * lengthwise(segment.length, v, v);
    energies[1] = segment.length * strain_energy(segment.strain, cable_);
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  /// Of the instant, without damping, N.
  template <class T, class Element>
  T elastic_tension(const Element& at) const {
    const CellInput& cell = *at.cell;
    const double before = strain_before<D>(at, displacement);
    const T after = strain_at_end<T, D>(at, displacement);
    return cell.held && taut(before) ? taut_tension_in_step(before, after, cell.share, cable_)
                                     : tension_in_step(before, after, cell.share, cable_);
  }
  /// x' . v', 1/s.
  template <class T, class Element>
  static T strain_rate(const Element& at, const Segment<T, D>& segment) {
    T rate = 0.0;
    for (int i = 0; i < D; ++i)
      rate += segment.stretch[i] * (at.value(velocity, 1, i) - at.value(velocity, 0, i));
    return rate / segment.length;
  }
  /// Integral of a . b along the segment, of nodal vectors.
  static double lengthwise(double length, const double* a, const double* b) {
    double sum = 0;
    for (int i = 0; i < D; ++i)
      sum += a[i] * (2 * b[i] + b[D + i]) + a[D + i] * (b[i] + 2 * b[D + i]);
    return length / 6 * sum;
  }
  bool taut(double strain) const { return strain >= cable_.slack_width; }

  CableProperties cable_;
  Vector<double, D> weight_;
};

}  // namespace hawser
