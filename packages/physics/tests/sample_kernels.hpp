#pragma once
// Small kernels whose residual and tangent are known.
#include <algorithm>

#include "hawser/physics/element_kernel.hpp"
#include "hawser/physics/moving_point_kernel.hpp"

namespace hawser {

constexpr FieldUse temperature{"temperature", "K", "W/m", 1, RateRule::dynamic};

/// Mass and stiffness of one scalar: integral of (rate + value) w + grad value . grad w.
template <int D>
class ScalarKernel : public PointKernel<ScalarKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr std::array<FieldUse, 1> uses = {
      temperature.as(Role::adds, need::value | need::rate | need::gradient)};
  static constexpr Slot<0> field{};
  explicit ScalarKernel(Domain domain = "body") : PointKernel<ScalarKernel>(std::move(domain)) {}

  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    out[field].source = at[field].value + at[field].rate;
    out[field].flux = at[field].gradient;
  }
};

/// Two geometries, each of which follows a velocity of its own.
class TwoFollowersKernel : public PointKernel<TwoFollowersKernel> {
 public:
  static constexpr int dimension = 2;
  static constexpr FieldUse first{
      "first",         "m", "m", 2, RateRule::quotient, Role::governs, need::value | need::rate,
      "first-velocity"};
  static constexpr FieldUse second{
      "second",         "m", "m", 1, RateRule::quotient, Role::governs, need::value | need::rate,
      "second-velocity"};
  static constexpr std::array<FieldUse, 4> uses = {
      FieldUse{"first-velocity", "m/s", "N", 2, RateRule::dynamic, Role::adds, need::value}, first,
      FieldUse{"second-velocity", "m/s", "N", 1, RateRule::dynamic, Role::adds, need::value},
      second};
  TwoFollowersKernel() : PointKernel("body") {}

  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    const auto& a = at[Slot<1>()];
    const auto& b = at[Slot<3>()];
    for (int i = 0; i < 2; ++i) {
      out[Slot<0>()].source[i] = a.rate[i] * b.value + at[Slot<0>()].value[i];
      out[Slot<1>()].source[i] = a.value[i] - a.rate[i] * a.rate[i];
    }
    out[Slot<2>()].source = b.rate * b.rate * a.value[0];
    out[Slot<3>()].source = b.value * b.rate - at[Slot<2>()].value;
  }
};

/// The same per element: a spring between two nodes, damped by the rate of its elongation.
class SpringKernel : public ElementKernel<SpringKernel> {
 public:
  static constexpr int dimension = 2;
  static constexpr CellShape shape = CellShape::line;
  static constexpr int node_count = 2;
  static constexpr std::array<FieldUse, 2> uses = {
      StandardFields<2>::velocity.as(Role::adds, need::value),
      StandardFields<2>::displacement.as(Role::kinematic, need::value | need::rate)};
  SpringKernel() : ElementKernel("line") {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    for (int i = 0; i < 2; ++i) {
      const T pull = at.value(1, 1, i) - at.value(1, 0, i) +
                     0.5 * (at.rate(1, 1, i) - at.rate(1, 0, i)) * at.value(0, 0, i);
      out[at.index(0, 0, i)] -= pull;
      out[at.index(0, 1, i)] += pull;
    }
  }
};

/// A flux that relaxes: grad T less r, which creeps after it by dr/dt = (grad T - r)/tau, tau = 2 s
/// (implicit Euler).
class CreepKernel : public MovingPointKernel<CreepKernel> {
 public:
  static constexpr int dimension = 2;
  static constexpr int memory = 2;
  static constexpr std::array<FieldUse, 2> uses = {
      temperature.as(Role::adds, need::value | need::gradient),
      StandardFields<2>::displacement.as(Role::reads_if_solved, need::gradient)};
  static constexpr Slot<0> field{};
  static constexpr Slot<1> displacement{};
  explicit CreepKernel(Domain domain = "body") : MovingPointKernel(std::move(domain)) {}

  template <class Point, class Form>
  void moved_form(const Point& at, Form& out) const {
    for (int i = 0; i < 2; ++i)
      out[field].flux[i] = at[field].gradient[i] - crept(at, i);
  }
  template <class Point>
  void moved_advance(const Point& at, double* next) const {
    for (int i = 0; i < 2; ++i)
      next[i] = crept(at, i);
  }

 private:
  template <class Point>
  static auto crept(const Point& at, int i) {
    const double share = at.elapsed / (at.elapsed + 2);
    using T = typename Point::Number;
    return T(at.memory[i] + share * (at[field].gradient[i] - at.memory[i]));
  }
};

/// A spring whose rest length yields: what it remembers is how far.
class YieldingSpringKernel : public ElementKernel<YieldingSpringKernel> {
 public:
  static constexpr int dimension = 2;
  static constexpr int memory = 1;
  static constexpr CellShape shape = CellShape::line;
  static constexpr int node_count = 2;
  static constexpr std::array<FieldUse, 1> uses = {
      StandardFields<2>::displacement.as(Role::governs, need::value)};
  YieldingSpringKernel() : ElementKernel("line") {}

  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    const T pull = at.value(0, 1, 0) - at.value(0, 0, 0) - at.memory(0);
    out[at.index(0, 0, 0)] -= pull;
    out[at.index(0, 1, 0)] += pull;
  }
  template <class Element>
  void advance(const Element& at, double* next) const {
    next[0] = std::max(at.memory(0), at.value(0, 1, 0) - at.value(0, 0, 0) - 0.25);
  }
};

/// Conduction on the moved mesh, unit conductivity, and the volume beside it.
template <int D>
class MovingKernel : public MovingPointKernel<MovingKernel<D>> {
 public:
  static constexpr int dimension = D;
  static constexpr std::array<FieldUse, 2> uses = {
      temperature.as(Role::adds, need::gradient),
      StandardFields<D>::displacement.as(Role::reads_if_solved, need::gradient)};
  static constexpr Slot<0> field{};
  static constexpr Slot<1> displacement{};
  MovingKernel() : MovingPointKernel<MovingKernel>("body") {}

  template <class Point, class Form>
  void moved_form(const Point& at, Form& out) const {
    out[field].source = 1.0;
    out[field].flux = at[field].gradient;
  }
};

}  // namespace hawser
