#pragma once
// Line elements of a slender cable in the velocity's own basis (theory.md).
#include <array>
#include <cmath>

#include "hawser/base/tensor.hpp"
#include "hawser/physics/element_kernel.hpp"

namespace hawser {

struct CableProperties {
  double mass = 60;              ///< per length, kg/m (in a flow in the plane: per metre of depth)
  double axial_stiffness = 1e7;  ///< EA, N
  double bending_stiffness = 0;  ///< EI, N m^2
  double damping = 0;            ///< external, N s/m per length
  double axial_damping = 0;      ///< internal, of the strain rate, N s
  double slack_width = 1e-5;     ///< strain over which the tension is switched off smoothly
  double compressive_ratio = 0;  ///< stiffness left in compression, relative to EA
};

/// Second Piola tension of a cable that carries no compression, continuously differentiable in the
/// strain: zero below -width, EA E above +width, a parabola between.
template <class T>
T slack_tension(const T& strain, const CableProperties& cable) {
  const double width = cable.slack_width;
  T tension = cable.compressive_ratio * strain;
  const double carried = 1 - cable.compressive_ratio;
  if (strain > width)
    tension += carried * strain;
  else if (strain > -width)
    tension += carried * (strain + width) * (strain + width) / (4 * width);
  return cable.axial_stiffness * tension;
}

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

/// Inertia, damping, membrane force and weight.
template <int D>
class CableKernel : public ElementKernel<CableKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr CellShape shape = CellShape::line;
  static constexpr int node_count = 2;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<D>::velocity.as(Role::adds, need::value | need::rate),
      StandardFields<D>::displacement.as(Role::kinematic, need::value)};
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  /// `weight`: N per reference length.
  CableKernel(Domain domain, const CableProperties& cable, const Vector<double, D>& weight)
      : ElementKernel<CableKernel>(std::move(domain)), cable_(cable), weight_(weight) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    const auto segment = segment_of<T, D>(at, displacement);
    T tension = slack_tension(segment.strain, cable_);
    for (int i = 0; i < D; ++i)
      tension += cable_.axial_damping / segment.length * segment.stretch[i] *
                 (at.value(velocity, 1, i) - at.value(velocity, 0, i));
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

  std::vector<Kernel::Quantity> quantities() const override { return {{"tension", "N", true}}; }
  /// The true tension, stretch times second Piola tension.
  void evaluate(const CellInput& cell, double* values) const override {
    const Segment<double, D> segment(
        [&](int a, int i) { return cell.coordinates[a * D + i]; },
        [&](int a, int i) { return cell.fields[displacement].value[a * D + i]; });
    values[0] = std::sqrt(1 + 2 * segment.strain) * slack_tension(segment.strain, cable_);
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  CableProperties cable_;
  Vector<double, D> weight_;
};

}  // namespace hawser
