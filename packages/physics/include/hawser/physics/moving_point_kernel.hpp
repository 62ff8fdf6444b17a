#pragma once
// A volume term on the moved mesh, written as if that were all there is: gradients are spatial, the
// source is per moved volume and the flux per moved area. The map to the reference mesh and the
// check that no cell is inverted are made here, once.
#include "hawser/physics/moving_frame.hpp"
#include "hawser/physics/point_kernel.hpp"

namespace hawser {

namespace detail {
/// A field in the moved configuration.
template <class Value, class Gradient>
struct MovedField {
  const Value& value;
  const Value& rate;         ///< at a fixed point of the reference mesh
  const Gradient& gradient;  ///< with respect to the moved coordinates
};

/// The displacement has no gradient there: that is in the frame.
template <class Value>
struct MovedDisplacement {
  const Value& value;
  const Value& rate;
};

/// Of field S; nothing for the displacement itself.
template <std::size_t S, int Displacement, class Point, class Frame>
auto spatial_gradient(const Point& point, const Frame& frame) {
  if constexpr (S == static_cast<std::size_t>(Displacement))
    return 0;
  else
    return frame.spatial(std::get<S>(point.fields).gradient);
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
  auto operator[](Slot<S> /*slot*/) const {
    const auto& field = std::get<S>(reference.fields);
    using Value = std::decay_t<decltype(field.value)>;
    if constexpr (S == Displacement) {
      return MovedDisplacement<Value>{field.value, field.rate};
    } else {
      const auto& gradient = std::get<S>(gradients_);
      return MovedField<Value, std::decay_t<decltype(gradient)>>{field.value, field.rate, gradient};
    }
  }

  /// (k, j) = d xi_k / d x_j of the moved cell, 1/m.
  auto inverse_jacobian() const { return multiply(reference.inverse_jacobian, frame.inverse); }

 private:
  std::tuple<decltype(spatial_gradient<I, Displacement>(std::declval<const Point&>(),
                                                        std::declval<const Frame&>()))...>
      gradients_;
};
}  // namespace detail

/// Derived has, beside what PointKernel asks for (but no weak_form):
///   static constexpr Slot<i> displacement{};   the field that moves the mesh; it needs its
///   gradient template <class Point, class Form> void moved_form(const Point& at, Form& out) const;
/// `at[field].gradient` is spatial, `out[field].source` per moved volume, `out[field].flux` per
/// moved area. What a Derived with `memory` remembers is given by
///   template <class Point> void moved_advance(const Point& at, double* next) const;
/// A Derived that stands in another configuration than the present one hides frame().
template <class Derived>
class MovingPointKernel : public PointKernel<Derived> {
 public:
  using PointKernel<Derived>::PointKernel;

  template <class Point>
  MovingFrame<typename Point::Number, Point::dimension> frame(const Point& at) const {
    constexpr unsigned needs = Derived::uses[decltype(Derived::displacement)::value].needs;
    static_assert((needs & need::gradient) != 0, "list the displacement with need::gradient");
    return MovingFrame<typename Point::Number, Point::dimension>(
        at[Derived::displacement].gradient);
  }

  template <class Point, class Form>
  void weak_form(const Point& reference, Form& out) const {
    const auto& self = static_cast<const Derived&>(*this);
    const auto frame = self.frame(reference);
    out.inverted = frame.inverted();
    if (out.inverted) return;
    self.moved_form(moved(reference, frame), out);
    detail::for_each_index(std::make_index_sequence<Derived::uses.size()>{}, [&](auto index) {
      if constexpr (has_rows(Derived::uses[index].role)) {
        auto& form = std::get<index>(out.fields);
        for (int c = 0; c < Derived::uses[index].components; ++c) {
          auto& source = detail::entry(form.source, c);
          source = frame.volume * source;
        }
        form.flux = frame.pull_back(form.flux);
      }
    });
  }

  template <class Point>
  void advance(const Point& reference, double* next) const {
    const auto& self = static_cast<const Derived&>(*this);
    const auto frame = self.frame(reference);
    self.moved_advance(moved(reference, frame), next);
  }

 protected:
  /// visit(at, weight, expansion) at every quadrature point of the moved mesh, in doubles: the
  /// weight is the moved volume of the point, m^dimension, and expansion the rate at which it
  /// grows, over the volume, 1/s.
  template <class Visit>
  void at_moved_points(const CellInput& cell, Visit&& visit) const {
    constexpr std::size_t d = decltype(Derived::displacement)::value;
    constexpr int D = Derived::dimension;
    const double* const rate = cell.fields[d].rate;
    this->at_points(cell,
                    [&](const auto& reference, double weight, int /*q*/, const auto& gradients) {
                      const auto frame = static_cast<const Derived&>(*this).frame(reference);
                      double expansion = 0;  // F^-1 : grad w
                      for (int a = 0; a < this->nodes(d); ++a)
                        for (int i = 0; i < D; ++i)
                          for (int k = 0; k < D; ++k)
                            expansion += frame.inverse(k, i) * gradients[d][a][k] * rate[a * D + i];
                      visit(moved(reference, frame), weight * frame.volume, expansion);
                    });
  }

 private:
  template <class Point, class Frame>
  static auto moved(const Point& reference, const Frame& frame) {
    using Indices = std::make_index_sequence<Derived::uses.size()>;
    return detail::MovedPoint<Point, Frame, decltype(Derived::displacement)::value, Indices>(
        reference, frame);
  }
};

}  // namespace hawser
