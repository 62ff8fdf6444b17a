#pragma once
// A volume term on the moved mesh, written as if that were all there is: gradients are spatial, the
// source is per moved volume and the flux per moved area. The map to the reference mesh and the
// check that no cell is inverted are made here, once.
#include "hawser/physics/moved_point.hpp"
#include "hawser/physics/point_kernel.hpp"

namespace hawser {

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
    return detail::frame_at<Derived>(at);
  }

  template <class Point, class Form>
  void weak_form(const Point& reference, Form& out) const {
    const auto& self = static_cast<const Derived&>(*this);
    const auto frame = self.frame(reference);
    out.inverted = frame.inverted();
    if (out.inverted) return;
    self.moved_form(detail::moved<Derived>(reference, frame), out);
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
    self.moved_advance(detail::moved<Derived>(reference, frame), next);
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
    this->at_points(
        cell, [&](const auto& reference, double weight, int /*q*/, const auto& gradients) {
          const auto frame = static_cast<const Derived&>(*this).frame(reference);
          double expansion = 0;  // F^-1 : grad w
          for (int a = 0; a < this->nodes(d); ++a)
            for (int i = 0; i < D; ++i)
              for (int k = 0; k < D; ++k)
                expansion += frame.inverse(k, i) * gradients[d][a][k] * rate[a * D + i];
          visit(detail::moved<Derived>(reference, frame), weight * frame.volume, expansion);
        });
  }
};

}  // namespace hawser
