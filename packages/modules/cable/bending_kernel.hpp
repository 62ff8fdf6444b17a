#pragma once
// Bending without rotations as unknowns: from the angle between neighbouring segments (theory.md).
#include <array>
#include <cmath>

#include "hawser/base/tensor.hpp"
#include "hawser/physics/element_kernel.hpp"

namespace hawser {

/// A moved segment: its vector, moved length and unit tangent.
template <class T, int D>
struct BentSegment {
  Vector<T, D> vector;   ///< m
  T length;              ///< m
  Vector<T, D> tangent;  ///< unit

  /// From the vector's components.
  template <class Component>
  explicit BentSegment(const Component& component) {
    for (int i = 0; i < D; ++i)
      vector[i] = component(i);
    using std::sqrt;
    length = sqrt(dot(vector, vector));
    for (int i = 0; i < D; ++i)
      tangent[i] = vector[i] / length;
  }
};

/// Between two nodes of an element kernel: its length on the reference, and the moved segment at
/// the start and the end of the step and at the instant of the equations.
template <class T, int D>
struct SegmentInStep {
  double reference_length = 0;  ///< m
  BentSegment<double, D> before;
  BentSegment<T, D> after, now;
  bool over_step;  ///< the direction is averaged over the step

  template <class Element>
  SegmentInStep(const Element& at, int field, int from, int to)
      : before([&](int i) {
          return span(at, from, to, i) + at.accepted(field, to, i) - at.accepted(field, from, i);
        }),
        after([&](int i) -> T {  // an expression would refer to what is gone
          return span(at, from, to, i) + at.end(field, to, i) - at.end(field, from, i);
        }),
        now([&](int i) -> T {
          return span(at, from, to, i) + at.value(field, to, i) - at.value(field, from, i);
        }),
        over_step(at.cell->bounds_energy) {
    for (int i = 0; i < D; ++i)
      reference_length += span(at, from, to, i) * span(at, from, to, i);
    reference_length = std::sqrt(reference_length);
  }

  /// A e, where A is d(tangent)/d(vector) at the instant, or over the step the symmetric A for
  /// which A (change of the vector) is the change of the tangent exactly: with the mean m of the
  /// vectors and of 1/length, A = mean(1/length) I - 2 m m / ((l0 + l1) l0 l1).
  Vector<T, D> turned(const Vector<T, D>& e) const {
    Vector<T, D> result;
    if (!over_step) {
      const T along = dot(e, now.tangent);
      for (int i = 0; i < D; ++i)
        result[i] = (e[i] - along * now.tangent[i]) / now.length;
      return result;
    }
    Vector<T, D> mean;
    for (int i = 0; i < D; ++i)
      mean[i] = 0.5 * (before.vector[i] + after.vector[i]);
    const T l0 = before.length, l1 = after.length;
    const T along = 2.0 * dot(e, mean) / ((l0 + l1) * l0 * l1);
    for (int i = 0; i < D; ++i)
      result[i] = 0.5 * (1.0 / l0 + 1.0 / l1) * e[i] - along * mean[i];
    return result;
  }

 private:
  template <class Element>
  static double span(const Element& at, int from, int to, int i) {
    return at.coordinate(to, i) - at.coordinate(from, i);
  }
};

/// Difference of two unit tangents at the instant; over a step the energy's derivative by it, whose
/// work is the gain of |e|^2/2 in the middle of the step, and more later.
template <class T, int D>
Vector<T, D> kink(const SegmentInStep<T, D>& first, const SegmentInStep<T, D>& second,
                  double share) {
  Vector<T, D> e;
  for (int i = 0; i < D; ++i)
    e[i] = first.over_step ? T((1 - share) * (second.before.tangent[i] - first.before.tangent[i]) +
                               share * (second.after.tangent[i] - first.after.tangent[i]))
                           : T(second.now.tangent[i] - first.now.tangent[i]);
  return e;
}

/// Three consecutive nodes: energy EI |t2 - t1|^2 / (2 l) with unit tangents t and l the mean
/// segment length.
template <int D>
class BendingKernel : public ElementKernel<BendingKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr CellShape shape = CellShape::line;
  static constexpr int node_count = 3;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<D>::velocity.as(Role::adds, 0U),
      StandardFields<D>::displacement.as(Role::kinematic, need::value | need::accepted)};
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  BendingKernel(Domain patches, double bending_stiffness)
      : ElementKernel<BendingKernel>(std::move(patches)), bending_stiffness_(bending_stiffness) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    const SegmentInStep<T, D> segments[2] = {{at, displacement, 0, 1}, {at, displacement, 1, 2}};
    const Vector<T, D> e = kink(segments[0], segments[1], at.cell->share);
    const double stiffness =
        2 * bending_stiffness_ / (segments[0].reference_length + segments[1].reference_length);
    for (int s = 0; s < 2; ++s) {
      const double sign = s == 0 ? -stiffness : stiffness;
      const Vector<T, D> turned = segments[s].turned(e);
      for (int i = 0; i < D; ++i) {
        out[at.index(velocity, s, i)] -= sign * turned[i];
        out[at.index(velocity, s + 1, i)] += sign * turned[i];
      }
    }
  }

  std::vector<EnergyTerm> energy_terms() const override {
    return {{"bending", EnergyTerm::Kind::stored}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    powers[0] = this->residual_times(cell, velocity);
  }
  void energies(const CellInput& cell, double* energies) const override {
    const auto at = this->element(cell);
    const SegmentInStep<double, D> segments[2] = {{at, displacement, 0, 1},
                                                  {at, displacement, 1, 2}};
    const Vector<double, D>*t = &segments[0].now.tangent, *u = &segments[1].now.tangent;
    double squared = 0;  // of the tangents' difference: 1 - cos would lose digits
    for (int i = 0; i < D; ++i)
      squared += ((*u)[i] - (*t)[i]) * ((*u)[i] - (*t)[i]);
    energies[0] = bending_stiffness_ * squared /
                  (segments[0].reference_length + segments[1].reference_length);
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  double bending_stiffness_;
};

/// A clamped point: the direction there stays the initial one, t0. The distance between the point
/// and the middle of the segment that begins there is half of the segment's length l, hence the
/// energy EI |t - t0|^2 / l.
template <int D>
class ClampKernel : public ElementKernel<ClampKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr CellShape shape = CellShape::line;
  static constexpr int node_count = 2;
  static constexpr std::array<FieldUse, 2> uses = BendingKernel<D>::uses;
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  ClampKernel(Domain ends, double bending_stiffness)
      : ElementKernel<ClampKernel>(std::move(ends)), bending_stiffness_(bending_stiffness) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    const SegmentInStep<T, D> segment(at, displacement, 0, 1);
    const double length = segment.reference_length, share = at.cell->share;
    Vector<T, D> e;
    for (int i = 0; i < D; ++i) {
      const double initial = (at.coordinate(1, i) - at.coordinate(0, i)) / length;
      e[i] = (segment.over_step
                  ? T((1 - share) * segment.before.tangent[i] + share * segment.after.tangent[i])
                  : segment.now.tangent[i]) -
             initial;
    }
    const Vector<T, D> turned = segment.turned(e);
    const double stiffness = 2 * bending_stiffness_ / length;
    for (int i = 0; i < D; ++i) {
      out[at.index(velocity, 0, i)] -= stiffness * turned[i];
      out[at.index(velocity, 1, i)] += stiffness * turned[i];
    }
  }

  std::vector<EnergyTerm> energy_terms() const override {
    return {{"bending", EnergyTerm::Kind::stored}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    powers[0] = this->residual_times(cell, velocity);
  }
  void energies(const CellInput& cell, double* energies) const override {
    const auto at = this->element(cell);
    const SegmentInStep<double, D> segment(at, displacement, 0, 1);
    double squared = 0;
    for (int i = 0; i < D; ++i) {
      const double initial = (at.coordinate(1, i) - at.coordinate(0, i)) / segment.reference_length;
      squared += (segment.now.tangent[i] - initial) * (segment.now.tangent[i] - initial);
    }
    energies[0] = bending_stiffness_ * squared / segment.reference_length;
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  double bending_stiffness_;
};

}  // namespace hawser
