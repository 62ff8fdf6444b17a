#pragma once
// Alone in a header so that the mesher can use it without linking the framework.
#include <cmath>

namespace hawser {

/// Quality of a triangle in the plane, 4 sqrt(3) area / (sum of squared edges), in [-1, 1]:
/// 1 is equilateral, 0 degenerate, negative clockwise (inverted).
inline double triangle_quality(const double* a, const double* b, const double* c) {
  const double ab[] = {b[0] - a[0], b[1] - a[1]};
  const double bc[] = {c[0] - b[0], c[1] - b[1]};
  const double ca[] = {a[0] - c[0], a[1] - c[1]};
  const double twice_area = ca[0] * ab[1] - ca[1] * ab[0];
  const double squares =
      ab[0] * ab[0] + ab[1] * ab[1] + bc[0] * bc[0] + bc[1] * bc[1] + ca[0] * ca[0] + ca[1] * ca[1];
  return squares > 0 ? 2 * std::sqrt(3.0) * twice_area / squares : 0;
}

}  // namespace hawser
