#pragma once
// The fields that a law declares in its `uses`, at the points of one cell, as independent variables
// of its derivative.
#include "hawser/element/cell_geometry.hpp"
#include "hawser/physics/cell_input.hpp"
#include "hawser/physics/field_at_point.hpp"

namespace hawser {

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
    std::tuple<
        FieldAtPoint<T, Derived::uses[I].components, Derived::dimension, Derived::uses[I].needs>...>
        fields;
    detail::PropertiesAtPoint<Derived, P> properties;
    double time = 0;
    double step = 0;
    double elapsed = 0;              ///< s, since the instant of what is remembered
    double share = 1;                ///< of the step, at which the equations are formed
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
    at.share = cell.share;
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
            line[offset[followed] + node] += N[a] * d[rate_at] * cell.fields[f].rate_partner[node];
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
