#pragma once
// A point of the moved mesh: what a law sees there as if that were all there is.
#include "hawser/physics/moving_frame.hpp"
#include "hawser/physics/point_fields.hpp"

namespace hawser::detail {

/// A field in the moved configuration.
template <class Value, class Rate, class Gradient>
struct MovedField {
  const Value& value;
  const Rate& rate;          ///< at a fixed point of the reference mesh
  const Gradient& gradient;  ///< with respect to the moved coordinates
};

/// The displacement has no gradient there: that is in the frame.
template <class Value, class Rate>
struct MovedDisplacement {
  const Value& value;
  const Rate& rate;
};

template <class Gradient, class Frame>
auto spatial(const Gradient& gradient, const Frame& frame) {
  return frame.spatial(gradient);
}
template <class Frame>
auto spatial(const add_need_gradient_to_the_uses_of_this_field& none, const Frame& /*frame*/) {
  return none;
}

/// Of field S; nothing for the displacement itself.
template <std::size_t S, int Displacement, class Point, class Frame>
auto spatial_gradient(const Point& point, const Frame& frame) {
  if constexpr (S == static_cast<std::size_t>(Displacement))
    return 0;
  else
    return spatial(std::get<S>(point.fields).gradient, frame);
}

template <class Point, class Frame, int Displacement, class Index>
class MovedPoint;
template <class Point, class Frame, int Displacement, std::size_t... I>
class MovedPoint<Point, Frame, Displacement, std::index_sequence<I...>> {
 public:
  using Number = typename Point::Number;
  static constexpr int dimension = Point::dimension;

  const Point& reference;  ///< the same in the reference configuration
  const Frame& frame;
  const double time, step, elapsed;           ///< s
  const double* const memory;                 ///< of the last accepted step
  const Vector<double, dimension>& position;  ///< reference coordinates X, m

  MovedPoint(const Point& point, const Frame& moved)
      : reference(point),
        frame(moved),
        time(point.time),
        step(point.step),
        elapsed(point.elapsed),
        memory(point.memory),
        position(point.position),
        gradients_(spatial_gradient<I, Displacement>(point, moved)...) {}

  template <int S>
  auto operator[](Slot<S> slot) const {
    const auto& field = reference[slot];
    using Value = std::decay_t<decltype(field.value)>;
    using Rate = std::decay_t<decltype(field.rate)>;
    if constexpr (S == Displacement) {
      return MovedDisplacement<Value, Rate>{field.value, field.rate};
    } else {
      const auto& gradient = std::get<S>(gradients_);
      return MovedField<Value, Rate, std::decay_t<decltype(gradient)>>{field.value, field.rate,
                                                                       gradient};
    }
  }
  template <int S>
  const auto& operator[](PropertySlot<S> slot) const {
    return reference[slot];
  }

  /// (k, j) = d xi_k / d x_j of the moved cell, 1/m.
  auto inverse_jacobian() const { return multiply(reference.inverse_jacobian, frame.inverse); }

 private:
  std::tuple<decltype(spatial_gradient<I, Displacement>(std::declval<const Point&>(),
                                                        std::declval<const Frame&>()))...>
      gradients_;
};

/// Of a Derived with a Slot `displacement`, whose use has need::gradient.
template <class Derived, class Point>
MovingFrame<typename Point::Number, Point::dimension> frame_at(const Point& at) {
  constexpr unsigned needs = Derived::uses[decltype(Derived::displacement)::value].needs;
  static_assert((needs & need::gradient) != 0, "list the displacement with need::gradient");
  return MovingFrame<typename Point::Number, Point::dimension>(at[Derived::displacement].gradient);
}

template <class Derived, class Point, class Frame>
auto moved(const Point& reference, const Frame& frame) {
  using Indices = std::make_index_sequence<Derived::uses.size()>;
  return MovedPoint<Point, Frame, decltype(Derived::displacement)::value, Indices>(reference,
                                                                                   frame);
}

}  // namespace hawser::detail
