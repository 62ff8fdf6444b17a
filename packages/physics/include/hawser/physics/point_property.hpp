#pragma once
// The law of a property, written once at a point; slopes are exact.
#include <algorithm>

#include "hawser/physics/moved_point.hpp"
#include "hawser/physics/property.hpp"

namespace hawser {

/// Derived has:  static constexpr int dimension;
///               static constexpr PropertyUse supplies;
///               static constexpr std::array<FieldUse, n> uses;   all of them only read
///               template <class Point> auto law(const Point& at) const;
/// `law` returns a Point::Number or, of several components, a Vector of them.
template <class Derived>
class PointProperty : public PropertySource, public PointFields<Derived> {
 public:
  static constexpr int memory = 0;
  static constexpr std::array<PropertyUse, 0> properties{};
  using PointFields<Derived>::directions;

  PointProperty() : PropertySource({Derived::uses.begin(), Derived::uses.end()}) {
    static_assert(all_described(Derived::uses),
                  "uses is longer than the list of fields given to it");
  }

  int dimension() const override { return Derived::dimension; }
  PropertyUse property() const override { return Derived::supplies; }
  std::unique_ptr<PropertySource> clone() const override {
    return std::make_unique<Derived>(static_cast<const Derived&>(*this));
  }
  void bind(const CellTabulation& table) override { this->table_ = table; }
  bool evaluate(const CellInput& cell, double* values, double* slopes) const override {
    if (slopes == nullptr) return evaluate_as<double>(cell, values, slopes);
    return evaluate_as<Sacado::Fad::SFad<double, std::max(directions(), 1)>>(cell, values, slopes);
  }

 private:
  template <class T>
  bool evaluate_as(const CellInput& cell, double* values, double* slopes) const;
};

/// The same on the moved mesh: gradients are spatial. Derived has, beside that,
///   static constexpr Slot<i> displacement{};   with need::gradient
/// and instead of law
///   template <class Point> auto moved_law(const Point& at) const;
template <class Derived>
class MovingPointProperty : public PointProperty<Derived> {
 public:
  template <class Point>
  auto law(const Point& reference, bool& inverted) const {
    const auto frame = detail::frame_at<Derived>(reference);
    inverted = frame.inverted();
    return static_cast<const Derived&>(*this).moved_law(detail::moved<Derived>(reference, frame));
  }
};

namespace detail {
template <class Law, class Point>
auto law_at(const Law& law, const Point& at, bool& inverted) {
  if constexpr (std::is_base_of_v<MovingPointProperty<Law>, Law>)
    return law.law(at, inverted);
  else
    return law.law(at);
}
}  // namespace detail

template <class Derived>
template <class T>
bool PointProperty<Derived>::evaluate_as(const CellInput& cell, double* values,
                                         double* slopes) const {
  constexpr int components = Derived::supplies.components;
  const auto offset = this->offsets();
  const int n = offset.back();
  auto at = this->template point<T, double>();
  detail::ShapeGradients<Derived> gradients;
  this->enter(cell, at);
  for (int q = 0; q < this->table_.rule.points; ++q) {
    this->go_to(q, cell, at, gradients);
    bool inverted = false;
    auto result = detail::law_at(static_cast<const Derived&>(*this), at, inverted);
    if (inverted) return false;
    for (int c = 0; c < components; ++c) {
      const auto& output = detail::entry(result, c);
      values[q * components + c] = detail::Number<T>::value(output);
      if constexpr (!std::is_same_v<T, double>) {
        double* const line = slopes + (q * components + c) * n;
        std::fill(line, line + n, 0.0);
        T number = output;
        this->contract(q, cell, gradients, offset, &number.fastAccessDx(0), line);
      }
    }
  }
  return true;
}

}  // namespace hawser
