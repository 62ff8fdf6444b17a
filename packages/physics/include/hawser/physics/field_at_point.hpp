#pragma once
// What a law sees of one field and of one property at a point, and what stands where it declared
// nothing.
#include <Sacado.hpp>

#include <array>
#include <tuple>
#include <type_traits>
#include <utility>

#include "hawser/base/tensor.hpp"
#include "hawser/physics/field_use.hpp"
#include "hawser/physics/property.hpp"

namespace hawser {

/// Names a field inside a kernel: `static constexpr Slot<0> temperature;` then
/// `at[temperature].value`.
template <int I>
using Slot = std::integral_constant<int, I>;

/// Names a property inside a kernel: `static constexpr PropertySlot<0> viscosity;` then
/// `at[viscosity]`.
template <int I>
struct PropertySlot {
  static constexpr int value = I;
};

// These stand where `uses` does not say that the law looks: a law that does look does not compile,
// and the compiler's message names them.
// NOLINTBEGIN(readability-identifier-naming): sentences of the compiler's message
struct add_need_value_to_the_uses_of_this_field {};
struct add_need_rate_to_the_uses_of_this_field {};
struct add_need_gradient_to_the_uses_of_this_field {};
struct add_need_accepted_to_the_uses_of_this_field {};
// NOLINTEND(readability-identifier-naming)

template <std::size_t N>
constexpr bool all_described(const std::array<FieldUse, N>& uses) {
  for (std::size_t f = 0; f < N; ++f)
    if (uses[f].name == nullptr) return false;
  return true;
}

namespace detail {
constexpr int max_nodes = 27;      // of one field on one cell: quadratic hexahedron
constexpr int max_unknowns = 192;  // of one cell

template <class T, int C, int D>
struct PointTypes {
  using Value = Vector<T, D>;
  using Gradient = Tensor<T, D>;
  static_assert(C == D, "a field has one component or as many as there are dimensions");
};
template <class T, int D>
struct PointTypes<T, 1, D> {
  using Value = T;
  using Gradient = Vector<T, D>;
};

template <unsigned Needs, unsigned Needed, class Type, class Complaint>
using IfNeeded = std::conditional_t<(Needs & Needed) != 0, Type, Complaint>;

template <class T>
T& entry(T& scalar, int /*component*/) {
  return scalar;
}
template <class T, int D>
T& entry(Vector<T, D>& vector, int component) {
  return vector[component];
}
template <class T, int D>
T& gradient_entry(Vector<T, D>& gradient, int /*component*/, int k) {
  return gradient[k];
}
template <class T, int D>
T& gradient_entry(Tensor<T, D>& gradient, int component, int k) {
  return gradient(component, k);
}

/// Of every field's shapes at a point: [field][node][dimension], 1/m.
template <class Derived>
using ShapeGradients = double[Derived::uses.size()][max_nodes][Derived::dimension];

template <class T>
struct Number {
  static T independent(int direction, double value) { return T(T().size(), direction, value); }
  static double value(const T& x) { return x.val(); }
};
template <>
struct Number<double> {
  static double independent(int /*direction*/, double value) { return value; }
  static double value(double x) { return x; }
};

template <std::size_t... I, class F>
void for_each_index(std::index_sequence<I...> /*indices*/, F&& f) {
  (f(std::integral_constant<std::size_t, I>()), ...);
}

template <std::size_t N>
constexpr int components(const std::array<PropertyUse, N>& properties, std::size_t count = N) {
  int sum = 0;
  for (std::size_t p = 0; p < count; ++p)
    sum += properties[p].components;
  return sum;
}

/// A property at a point: a number, or a vector of as many as it has components.
template <class P, int C>
struct PropertyType {
  using Value = Vector<P, C>;
};
template <class P>
struct PropertyType<P, 1> {
  using Value = P;
};
template <class Derived, class P,
          class Index = std::make_index_sequence<Derived::properties.size()>>
struct PropertiesAtPoint;
template <class Derived, class P, std::size_t... I>
struct PropertiesAtPoint<Derived, P, std::index_sequence<I...>> {
  std::tuple<typename PropertyType<P, Derived::properties[I].components>::Value...> all;
};
}  // namespace detail

/// One field at a point: scalars have a T and a Vector, vectors have a Vector and a Tensor. Only
/// what the use `needs`.
template <class T, int C, int D, unsigned Needs>
struct FieldAtPoint {
  using Value = typename detail::PointTypes<T, C, D>::Value;
  using Gradient = typename detail::PointTypes<T, C, D>::Gradient;
  using Accepted = typename detail::PointTypes<double, C, D>::Gradient;
  detail::IfNeeded<Needs, need::value, Value, add_need_value_to_the_uses_of_this_field> value{};
  /// d/dt at fixed reference point
  detail::IfNeeded<Needs, need::rate, Value, add_need_rate_to_the_uses_of_this_field> rate{};
  /// with respect to reference coordinates
  detail::IfNeeded<Needs, need::gradient, Gradient, add_need_gradient_to_the_uses_of_this_field>
      gradient{};
  /// at the last accepted step
  detail::IfNeeded<Needs, need::accepted, Accepted, add_need_accepted_to_the_uses_of_this_field>
      accepted_gradient{};
};

}  // namespace hawser
