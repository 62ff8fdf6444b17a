#pragma once
// What every trap begins with: a kernel of one scalar and a field that it only reads.
#include "hawser/physics/moving_point_kernel.hpp"

namespace hawser {
constexpr FieldUse scalar{"scalar", "1", "1", 1, RateRule::dynamic};

template <class Derived>
class Trap : public PointKernel<Derived> {
 public:
  static constexpr int dimension = 2;
  static constexpr std::array<FieldUse, 2> uses = {
      scalar.as(Role::adds, need::gradient),
      StandardFields<2>::velocity.as(Role::reads, need::value)};
  static constexpr Slot<0> u{};
  static constexpr Slot<1> velocity{};
  Trap() : PointKernel<Derived>("body") {}
};
}  // namespace hawser
