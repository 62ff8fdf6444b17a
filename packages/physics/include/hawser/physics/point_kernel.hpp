#pragma once
// A volume term, written once at a quadrature point.
//
// The author gives, per field, a source s and a flux f; the residual is
//     R(w) = integral over the reference cell of  s . w + f : grad w .
// The derivative is taken with respect to the values, rates and gradients at the *point* (Sacado,
// fixed size), then contracted with the tabulated shapes: the number of directions does not grow
// with the order of the elements.
#include <Sacado.hpp>

#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "hawser/element/cell_geometry.hpp"
#include "hawser/physics/kernel.hpp"

namespace hawser {

/// Names a field inside a kernel: `static constexpr Slot<0> temperature;` then
/// `at[temperature].value`.
template <int I>
using Slot = std::integral_constant<int, I>;

namespace detail {
constexpr int max_nodes = 27;      // of one field on one cell: quadratic hexahedron
constexpr int max_unknowns = 192;  // of one cell

/// PluginError when the cell's unknowns do not fit into the arrays that the loop has on its stack.
void check_size(const Kernel& kernel, const CellTabulation& table);

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
}  // namespace detail

/// One field at a point: scalars have a T and a Vector, vectors have a Vector and a Tensor.
template <class T, int C, int D>
struct FieldAtPoint {
  typename detail::PointTypes<T, C, D>::Value value{};
  typename detail::PointTypes<T, C, D>::Value rate{};  ///< d/dt at fixed reference point
  typename detail::PointTypes<T, C, D>::Gradient
      gradient{};  ///< with respect to reference coordinates
  typename detail::PointTypes<double, C, D>::Gradient
      accepted_gradient{};  ///< at the last accepted step
};

template <class T, int C, int D>
struct FormAtPoint {
  typename detail::PointTypes<T, C, D>::Value source{};
  typename detail::PointTypes<T, C, D>::Gradient flux{};
};

/// Derived has:  static constexpr int dimension;
///               static constexpr std::array<FieldUse, n> uses;
///               template <class Point, class Form> void weak_form(const Point& at, Form& out)
///               const;
/// `typename Point::Number` is the number type; set out.inverted when det F <= 0.
/// One that remembers something at each quadrature point hides
///               static constexpr int memory;   doubles per point
/// reads at.memory[i] and has
///               template <class Point> void advance(const Point& at, double* next) const;
/// which is evaluated with doubles on acceptance (Kernel::advance_memory).
template <class Derived>
class PointKernel : public Kernel {
 public:
  static constexpr int memory = 0;

  explicit PointKernel(Domain domain)
      : Kernel(std::move(domain), {Derived::uses.begin(), Derived::uses.end()}) {}

  int dimension() const override { return Derived::dimension; }
  std::vector<CellShape> shapes() const override {
    if (Derived::dimension == 2) return {CellShape::triangle, CellShape::quadrilateral};
    return {CellShape::tetrahedron, CellShape::hexahedron};
  }

  void bind(const CellTabulation& table) override {
    detail::check_size(*this, table);
    table_ = table;
  }
  int nodes(std::size_t field) const override { return table_.fields[field].nodes; }

  CellStatus residual(const CellInput& cell, double* residual) const override {
    return evaluate<double>(cell, residual, nullptr);
  }
  CellStatus tangent(const CellInput& cell, double* residual, double* tangent) const override {
    return evaluate<Sacado::Fad::SFad<double, directions()>>(cell, residual, tangent);
  }

  int memory_per_cell() const override { return table_.rule.points * Derived::memory; }
  void advance_memory(const CellInput& cell, double* next) const override;

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
  /// visit(at, weight, q, gradients) at every quadrature point, in doubles: the weight is the
  /// reference volume of the point, m^dimension, gradients[field][node][k] those of the shapes,
  /// 1/m.
  template <class Visit>
  void at_points(const CellInput& cell, Visit&& visit) const;

 private:
  template <class T, class Index>
  struct PointOf;
  template <class T, std::size_t... I>
  struct PointOf<T, std::index_sequence<I...>> : CellGeometry<Derived::dimension> {
    using Number = T;
    static constexpr int dimension = Derived::dimension;
    std::tuple<FieldAtPoint<T, Derived::uses[I].components, Derived::dimension>...> fields;
    double time = 0;
    double step = 0;
    double elapsed = 0;              ///< s, since the instant of what is remembered
    const double* memory = nullptr;  ///< [Derived::memory], of the last accepted step
    template <int S>
    const auto& operator[](Slot<S>) const {
      return std::get<S>(fields);
    }
  };
  template <class T, class Index>
  struct FormOf;
  template <class T, std::size_t... I>
  struct FormOf<T, std::index_sequence<I...>> {
    std::tuple<FormAtPoint<T, Derived::uses[I].components, Derived::dimension>...> fields;
    bool inverted = false;
    template <int S>
    auto& operator[](Slot<S>) {
      return std::get<S>(fields);
    }
  };

  template <class At>
  void enter(const CellInput& cell, At& at) const;
  /// Values, rates and gradients of every field at point q, each an independent variable, and the
  /// gradients of the shapes.
  template <class At, class Gradients>
  void go_to(int q, const CellInput& cell, At& at, Gradients& gradients) const;
  template <class T>
  CellStatus evaluate(const CellInput& cell, double* residual, double* tangent) const;

  CellTabulation table_;
};

}  // namespace hawser

#include "hawser/physics/point_kernel_impl.hpp"
