#pragma once
// Bending without rotations as unknowns: from the angle between neighbouring segments (theory.md).
#include <array>
#include <cmath>

#include "hawser/base/tensor.hpp"
#include "hawser/physics/element_kernel.hpp"

namespace hawser {

/// The moved segment between two nodes of an element kernel.
template <class T, int D>
struct BentSegment {
  double length = 0;     ///< of the reference, m
  T inverse_length;      ///< of the moved segment
  Vector<T, D> tangent;  ///< of the moved segment, unit

  template <class Element>
  BentSegment(const Element& at, int displacement, int from, int to) {
    T squared = 0.0;
    for (int i = 0; i < D; ++i) {
      const double span = at.coordinate(to, i) - at.coordinate(from, i);
      length += span * span;
      tangent[i] = span + at.value(displacement, to, i) - at.value(displacement, from, i);
      squared += tangent[i] * tangent[i];
    }
    length = std::sqrt(length);
    using std::sqrt;
    inverse_length = 1.0 / sqrt(squared);
    for (int i = 0; i < D; ++i)
      tangent[i] *= inverse_length;
  }
};

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
      StandardFields<D>::displacement.as(Role::kinematic, need::value)};
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  BendingKernel(Domain patches, double bending_stiffness)
      : ElementKernel<BendingKernel>(std::move(patches)), bending_stiffness_(bending_stiffness) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    const BentSegment<T, D> segments[2] = {{at, displacement, 0, 1}, {at, displacement, 1, 2}};
    const T cosine = dot(segments[0].tangent, segments[1].tangent);
    const double stiffness = 2 * bending_stiffness_ / (segments[0].length + segments[1].length);
    for (int s = 0; s < 2; ++s)
      for (int i = 0; i < D; ++i) {
        // d(energy)/d(segment vector): the part of the other tangent normal to this one.
        const T pull = -stiffness * segments[s].inverse_length *
                       (segments[1 - s].tangent[i] - cosine * segments[s].tangent[i]);
        out[at.index(velocity, s, i)] -= pull;
        out[at.index(velocity, s + 1, i)] += pull;
      }
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
    const BentSegment<T, D> segment(at, displacement, 0, 1);
    Vector<double, D> initial;
    for (int i = 0; i < D; ++i)
      initial[i] = (at.coordinate(1, i) - at.coordinate(0, i)) / segment.length;
    const T cosine = dot(segment.tangent, initial);
    const double stiffness = 2 * bending_stiffness_ / segment.length;
    for (int i = 0; i < D; ++i) {
      const T pull =
          -stiffness * segment.inverse_length * (initial[i] - cosine * segment.tangent[i]);
      out[at.index(velocity, 0, i)] -= pull;
      out[at.index(velocity, 1, i)] += pull;
    }
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  double bending_stiffness_;
};

}  // namespace hawser
