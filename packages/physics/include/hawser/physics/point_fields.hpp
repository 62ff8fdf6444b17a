#pragma once
// The fields that a law declares in its `uses`, at the points of one cell, as independent variables
// of its derivative.
#include <Sacado.hpp>

#include <array>
#include <tuple>
#include <type_traits>
#include <utility>

#include "hawser/element/cell_geometry.hpp"
#include "hawser/physics/cell_input.hpp"
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
struct add_need_value_to_the_uses_of_this_field {};
struct add_need_rate_to_the_uses_of_this_field {};
struct add_need_gradient_to_the_uses_of_this_field {};
struct add_need_accepted_to_the_uses_of_this_field {};

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
template <class Derived, class P, class Index = std::make_index_sequence<Derived::properties.size()>>
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

/// Derived has `dimension`, `uses` and perhaps `memory` and `properties`, as PointKernel says.
template <class Derived>
class PointFields {
 public:
  /// Derivative directions of one field: its value, rate and gradient, as far as they are looked
  /// at.
  static constexpr int directions(const FieldUse& use) {
    return use.components *
           (((use.needs & need::value) != 0 ? 1 : 0) + ((use.needs & need::rate) != 0 ? 1 : 0) +
            ((use.needs & need::gradient) != 0 ? Derived::dimension : 0));
  }
  static constexpr int directions() {
    int sum = 0;
    for (const FieldUse& use : Derived::uses)
      sum += directions(use);
    return sum;
  }

 protected:
  /// T: the number of fields, P: that of properties.
  template <class T, class P, class Index>
  struct PointAt;
  template <class T, class P, std::size_t... I>
  struct PointAt<T, P, std::index_sequence<I...>> : CellGeometry<Derived::dimension> {
    using Number = T;
    static constexpr int dimension = Derived::dimension;
    std::tuple<FieldAtPoint<T, Derived::uses[I].components, Derived::dimension,
                            Derived::uses[I].needs>...>
        fields;
    detail::PropertiesAtPoint<Derived, P> properties;
    double time = 0;
    double step = 0;
    double elapsed = 0;              ///< s, since the instant of what is remembered
    const double* memory = nullptr;  ///< [Derived::memory], of the last accepted step
    template <int S>
    const auto& operator[](Slot<S> /*slot*/) const {
      static_assert(0 <= S && S < static_cast<int>(sizeof...(I)),
                    "this slot is beyond the kernel's uses");
      return std::get<S>(fields);
    }
    template <int S>
    const auto& operator[](PropertySlot<S> /*slot*/) const {
      static_assert(0 <= S && S < static_cast<int>(Derived::properties.size()),
                    "this slot is beyond the kernel's properties");
      return std::get<S>(properties.all);
    }
  };

  template <class T, class P>
  static auto point() {
    return PointAt<T, P, std::make_index_sequence<Derived::uses.size()>>();
  }

  template <class At>
  void enter(const CellInput& cell, At& at) const {
    at.time = cell.time;
    at.step = cell.step;
    at.elapsed = cell.elapsed;
    at.CellGeometry<Derived::dimension>::enter(table_, cell.coordinates);
  }

  /// Values, rates and gradients of every field at point q, each an independent variable, and the
  /// gradients of the shapes.
  template <class At, class Gradients>
  void go_to(int q, const CellInput& cell, At& at, Gradients& gradients) const;

  /// One line of the point Jacobian times the shapes of all columns: adds to line[offset[f] + node
  /// * components + c] for the cell's unknowns, rates following their values.
  template <class Gradients, class Offsets>
  void contract(int q, const CellInput& cell, const Gradients& gradients, const Offsets& offset,
                const double* derivative, double* line) const;

  /// First unknown of each field, and their number.
  auto offsets() const {
    std::array<int, Derived::uses.size() + 1> offset{};
    for (std::size_t f = 0; f < Derived::uses.size(); ++f)
      offset[f + 1] = offset[f] + table_.fields[f].nodes * Derived::uses[f].components;
    return offset;
  }

  CellTabulation table_;
};

template <class Derived>
template <class At, class Gradients>
void PointFields<Derived>::go_to(int q, const CellInput& cell, At& at, Gradients& gradients) const {
  constexpr int D = Derived::dimension;
  using Num = detail::Number<typename At::Number>;
  at.CellGeometry<D>::go_to(q, table_, cell.coordinates);
  at.memory = cell.memory + q * Derived::memory;
  int direction = 0;
  detail::for_each_index(std::make_index_sequence<Derived::uses.size()>{}, [&](auto index) {
    constexpr std::size_t f = index;
    constexpr int components = Derived::uses[f].components;
    constexpr unsigned needs = Derived::uses[f].needs;
    const Tabulation& shape = table_.fields[f];
    const double* const N = &shape.values[q * shape.nodes];
    const double* const local = &shape.gradients[q * shape.nodes * D];
    const bool new_gradients = q == 0 || !(table_.affine && shape.linear);
    if (new_gradients)
      for (int a = 0; a < shape.nodes; ++a)
        for (int j = 0; j < D; ++j) {
          double sum = 0;
          for (int k = 0; k < D; ++k)
            sum += local[a * D + k] * at.inverse_jacobian(k, j);
          gradients[f][a][j] = sum;
        }
    const auto interpolate = [&](const double* nodal, int c) {
      double sum = 0;
      for (int a = 0; a < shape.nodes; ++a)
        sum += N[a] * nodal[a * components + c];
      return sum;
    };
    const auto slope = [&](const double* nodal, int c, int j) {
      double sum = 0;
      for (int a = 0; a < shape.nodes; ++a)
        sum += gradients[f][a][j] * nodal[a * components + c];
      return sum;
    };
    auto& field = std::get<f>(at.fields);
    const FieldOnCell& nodal = cell.fields[f];
    for (int c = 0; c < components; ++c) {
      if constexpr ((needs & need::value) != 0)
        detail::entry(field.value, c) = Num::independent(direction++, interpolate(nodal.value, c));
      if constexpr ((needs & need::rate) != 0)
        detail::entry(field.rate, c) = Num::independent(direction++, interpolate(nodal.rate, c));
      if constexpr ((needs & need::gradient) != 0) {
        for (int j = 0; j < D && new_gradients; ++j)
          detail::gradient_entry(field.gradient, c, j) =
              Num::independent(direction + j, slope(nodal.value, c, j));
        direction += D;
      }
      if constexpr ((needs & need::accepted) != 0)
        for (int j = 0; j < D && new_gradients; ++j)
          detail::gradient_entry(field.accepted_gradient, c, j) = slope(nodal.accepted, c, j);
    }
  });
}

template <class Derived>
template <class Gradients, class Offsets>
void PointFields<Derived>::contract(int q, const CellInput& cell, const Gradients& gradients,
                                    const Offsets& offset, const double* derivative,
                                    double* line) const {
  constexpr int D = Derived::dimension;
  int first = 0;
  detail::for_each_index(std::make_index_sequence<Derived::uses.size()>{}, [&](auto index) {
    constexpr std::size_t f = index;
    constexpr int components = Derived::uses[f].components;
    constexpr unsigned needs = Derived::uses[f].needs;
    constexpr int followed = rate_partners(Derived::uses)[f];
    constexpr int width = directions(Derived::uses[f]) / components;
    constexpr int rate_at = (needs & need::value) != 0 ? 1 : 0;
    constexpr int gradient_at = rate_at + ((needs & need::rate) != 0 ? 1 : 0);
    const double* const N = &table_.fields[f].values[q * table_.fields[f].nodes];
    for (int a = 0; a < table_.fields[f].nodes; ++a)
      for (int c = 0; c < components; ++c) {
        const double* const d = derivative + first + c * width;
        const int node = a * components + c;
        double sum = 0;
        if constexpr ((needs & need::value) != 0) sum += N[a] * d[0];
        if constexpr ((needs & need::rate) != 0) {
          sum += N[a] * d[rate_at] * cell.fields[f].rate_slope[node];
          // Of a node that the followed field lacks the partner is 0: it may go anywhere.
          if constexpr (followed >= 0)
            line[offset[followed] + node] +=
                N[a] * d[rate_at] * cell.fields[f].rate_partner[node];
        }
        if constexpr ((needs & need::gradient) != 0)
          for (int j = 0; j < D; ++j)
            sum += gradients[f][a][j] * d[gradient_at + j];
        line[offset[f] + node] += sum;
      }
    first += width * components;
  });
}

}  // namespace hawser
