#pragma once
// Gauss' rule along a segment of a line, for kernels that are written per segment.
#include <array>

#include "hawser/base/tensor.hpp"

namespace hawser {

/// s from 0 at the segment's first node to 1.
struct GaussPoint {
  double s, weight;
};
constexpr std::array<GaussPoint, 3> three_points = {
    {{0.11270166537925831, 5.0 / 18}, {0.5, 8.0 / 18}, {0.88729833462074169, 5.0 / 18}}};

/// Where a point of a segment was at first and how far it has moved, m.
template <class T, int D>
struct PointOnSegment {
  Vector<double, D> reference;
  Vector<T, D> displacement;

  template <class Element>
  PointOnSegment(const Element& at, int field, const GaussPoint& point) {
    for (int i = 0; i < D; ++i) {
      reference[i] = (1 - point.s) * at.coordinate(0, i) + point.s * at.coordinate(1, i);
      displacement[i] = (1 - point.s) * at.value(field, 0, i) + point.s * at.value(field, 1, i);
    }
  }
};

}  // namespace hawser
