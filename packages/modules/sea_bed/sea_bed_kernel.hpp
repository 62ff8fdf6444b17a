#pragma once
// The ground under a line: a soft layer that pushes up and rubs (theory.md).
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "hawser/base/tensor.hpp"
#include "hawser/physics/element_kernel.hpp"
#include "hawser/physics/place_function.hpp"
#include "hawser/physics/segment_points.hpp"

namespace hawser {

struct SeaBedProperties {
  double stiffness = 1e4;     ///< of the ground, N/m of depth per length of line
  double onset = 0.01;        ///< m, over which the reaction sets in
  double friction = 0;        ///< Coulomb's coefficient
  double creep_speed = 0.01;  ///< m/s, over which friction sets in
};

/// A line at the depth g in the ground carries k h(g) upward per reference length, h = 0 below
/// -onset, g above onset, a parabola between; and across that mu k h(g) against its velocity.
template <int D>
class SeaBedKernel : public ElementKernel<SeaBedKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr CellShape shape = CellShape::line;
  static constexpr int node_count = 2;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<D>::velocity.as(Role::adds, need::value),
      StandardFields<D>::displacement.as(Role::reads, need::value)};
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  /// `level`: m, the last coordinate of the ground.
  SeaBedKernel(Domain lines, const SeaBedProperties& bed, Expression level)
      : ElementKernel<SeaBedKernel>(std::move(lines)), bed_(bed), level_(std::move(level)) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    using std::sqrt;
    for (const GaussPoint& on_segment : three_points) {
      const Point<T> point(*this, at, on_segment);
      const T reaction = bed_.stiffness * pressed(point.depth);
      T squared = bed_.creep_speed * bed_.creep_speed;
      for (int i = 0; i + 1 < D; ++i)
        squared += point.velocity[i] * point.velocity[i];
      const T drag = bed_.friction * reaction / sqrt(squared);
      for (int i = 0; i < D; ++i) {
        const T force = i + 1 == D ? reaction : T(-drag * point.velocity[i]);
        out[at.index(velocity, 0, i)] -= (1 - on_segment.s) * point.length * force;
        out[at.index(velocity, 1, i)] -= on_segment.s * point.length * force;
      }
    }
  }

  std::vector<EnergyTerm> energy_terms() const override {
    return {{"sea bed", EnergyTerm::Kind::stored}, {"friction", EnergyTerm::Kind::dissipated}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    const auto at = this->element(cell);
    powers[0] = 0;
    for (const GaussPoint& on_segment : three_points) {
      const Point<double> point(*this, at, on_segment);
      powers[0] -= point.length * bed_.stiffness * pressed(point.depth) * point.velocity[D - 1];
    }
    powers[1] = this->residual_times(cell, velocity) - powers[0];
  }
  void energies(const CellInput& cell, double* energies) const override {
    const auto at = this->element(cell);
    energies[0] = 0;
    for (const GaussPoint& on_segment : three_points) {
      const Point<double> point(*this, at, on_segment);
      const double above = point.depth + bed_.onset;
      if (point.depth > bed_.onset)
        energies[0] += point.length * bed_.stiffness *
                       (0.5 * point.depth * point.depth + bed_.onset * bed_.onset / 6);
      else if (above > 0)
        energies[0] += point.length * bed_.stiffness * above * above * above / (12 * bed_.onset);
    }
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  template <class T>
  struct Point {
    double length = 0;      // m of reference that it stands for
    T depth;                // m, below the ground
    Vector<T, D> velocity;  // m/s

    template <class Element>
    Point(const SeaBedKernel& kernel, const Element& at, const GaussPoint& on_segment) {
      const PointOnSegment<T, D> place(at, SeaBedKernel::displacement, on_segment);
      const double s = on_segment.s;
      double squared = 0;
      for (int i = 0; i < D; ++i) {
        const double way = at.coordinate(1, i) - at.coordinate(0, i);
        squared += way * way;
        velocity[i] = (1 - s) * at.value(SeaBedKernel::velocity, 0, i) +
                      s * at.value(SeaBedKernel::velocity, 1, i);
      }
      length = on_segment.weight * std::sqrt(squared);
      depth = at_place(kernel.level_, place.reference, place.displacement, at.time()) -
              place.reference[D - 1] - place.displacement[D - 1];
    }
  };

  template <class T>
  T pressed(const T& depth) const {
    if (depth >= bed_.onset) return depth;
    if (depth <= -bed_.onset) return T(0.0);
    return (depth + bed_.onset) * (depth + bed_.onset) / (4 * bed_.onset);
  }

  SeaBedProperties bed_;
  Expression level_;
};

}  // namespace hawser
