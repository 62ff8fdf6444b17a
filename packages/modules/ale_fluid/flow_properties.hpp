#pragma once
// What every kernel of the flow is given of the fluid.
#include "hawser/physics/point_fields.hpp"

namespace hawser {

/// A kernel inherits these slots; its `properties` begin with this density, viscosity and eddy
/// viscosity.
struct FlowProperties {
  static constexpr PropertySlot<0> density{};
  static constexpr PropertySlot<1> viscosity{};
  static constexpr PropertySlot<2> eddy_viscosity{};

  /// Molecular and turbulent, Pa s.
  template <class Point>
  static auto total_viscosity(const Point& at) {
    using P = std::decay_t<decltype(at[viscosity])>;
    return P(at[viscosity] + at[density] * at[eddy_viscosity]);
  }
};

}  // namespace hawser
