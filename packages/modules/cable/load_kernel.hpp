#pragma once
// Distributed and point loads given by expressions of place and time (theory.md).
#include <array>
#include <cmath>

#include "axial_kernel.hpp"
#include "hawser/physics/place_function.hpp"
#include "hawser/physics/segment_points.hpp"

namespace hawser {

/// N per reference length, at the moved place of each point of the reference.
template <int D>
class CableLoadKernel : public ElementKernel<CableLoadKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr CellShape shape = CellShape::line;
  static constexpr int node_count = 2;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<D>::velocity.as(Role::adds, 0U),
      StandardFields<D>::displacement.as(Role::kinematic, need::value)};
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  CableLoadKernel(Domain domain, Expressions load)
      : ElementKernel<CableLoadKernel>(std::move(domain)), load_(std::move(load)) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    const double length = segment_of<T, D>(at, displacement).length;
    for (const GaussPoint& point : three_points) {
      const PointOnSegment<T, D> place(at, displacement, point);
      for (int i = 0; i < D; ++i) {
        const T load = point.weight * length *
                       at_place(load_[static_cast<std::size_t>(i)], place.reference,
                                place.displacement, at.time());
        out[at.index(velocity, 0, i)] -= (1 - point.s) * load;
        out[at.index(velocity, 1, i)] -= point.s * load;
      }
    }
  }

  std::vector<EnergyTerm> energy_terms() const override {
    return {{"loads", EnergyTerm::Kind::supplied}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    powers[0] = this->residual_times(cell, velocity);
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  Expressions load_;
};

/// N at every vertex of a point region.
template <int D>
class PointLoadKernel : public ElementKernel<PointLoadKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr CellShape shape = CellShape::point;
  static constexpr int node_count = 1;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<D>::velocity.as(Role::adds, 0U),
      StandardFields<D>::displacement.as(Role::reads, need::value)};
  static constexpr int velocity = 0;
  static constexpr int displacement = 1;

  PointLoadKernel(Domain points, Expressions force)
      : ElementKernel<PointLoadKernel>(std::move(points)), force_(std::move(force)) {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    Vector<double, D> place;
    Vector<T, D> moved;
    for (int i = 0; i < D; ++i) {
      place[i] = at.coordinate(0, i);
      moved[i] = at.value(displacement, 0, i);
    }
    for (int i = 0; i < D; ++i)
      out[at.index(velocity, 0, i)] -=
          at_place(force_[static_cast<std::size_t>(i)], place, moved, at.time());
  }

  std::vector<EnergyTerm> energy_terms() const override {
    return {{"loads", EnergyTerm::Kind::supplied}};
  }
  void powers(const CellInput& cell, double* powers) const override {
    powers[0] = this->residual_times(cell, velocity);
  }

  std::vector<double> sample_amplitudes() const override { return {1.0, 0.05}; }

 private:
  Expressions force_;
};

}  // namespace hawser
