#pragma once
// A volume term, written once at a quadrature point.
//
// The author gives, per field, a source s and a flux f; the residual is
//     R(w) = integral over the reference cell of  s . w + f : grad w .
// The derivative is taken with respect to the values, rates and gradients at the *point* (Sacado,
// fixed size), then contracted with the tabulated shapes: the number of directions does not grow
// with the order of the elements. Properties that others supply are independent variables too; the
// slopes of their laws carry them on to the unknowns.
#include <algorithm>
#include <cmath>

#include "hawser/physics/kernel.hpp"
#include "hawser/physics/point_fields.hpp"

namespace hawser {

namespace detail {
/// PluginError when the cell's unknowns do not fit into the arrays that the loop has on its stack.
void check_size(const Kernel& kernel, const CellTabulation& table);
/// PluginError when a kernel that is not `on_facets` has a domain of facets, or the other way
/// round: its weights would be others.
void check_domain(const Kernel& kernel, bool on_facets);
}  // namespace detail

// NOLINTNEXTLINE(readability-identifier-naming): a sentence of the compiler's message
struct this_field_is_only_read_and_takes_no_source_and_no_flux {};

template <class T, int C, int D, bool Writes>
struct FormAtPoint {
  typename detail::PointTypes<T, C, D>::Value source{};
  typename detail::PointTypes<T, C, D>::Gradient flux{};
};
template <class T, int C, int D>
struct FormAtPoint<T, C, D, false> {
  this_field_is_only_read_and_takes_no_source_and_no_flux source, flux;
};

/// Derived has:  static constexpr int dimension;
///               static constexpr std::array<FieldUse, n> uses;
///               template <class Point, class Form> void weak_form(const Point& at, Form& out)
///               const;
/// `typename Point::Number` is the number type; set out.inverted when det F <= 0.
/// One that works on the facets of a boundary (Domain::facets), with the shapes of the cells behind
/// them, hides
///               static constexpr bool on_facets = true;
/// Its source is per reference measure of the facet: an outward load per area times at.facet().
/// One that uses properties hides
///               static constexpr std::array<PropertyUse, m> properties;
/// hands the constants that its module gives to the constructor, and reads at[PropertySlot<i>]: a
/// number with derivatives where somebody supplies it, else a double.
/// One that remembers something at each quadrature point hides
///               static constexpr int memory;   doubles per point
/// reads at.memory[i] and has
///               template <class Point> void advance(const Point& at, double* next) const;
/// which is evaluated with doubles on acceptance (Kernel::advance_memory).
template <class Derived>
class PointKernel : public Kernel, public PointFields<Derived> {
 public:
  static constexpr int memory = 0;
  static constexpr bool on_facets = false;
  static constexpr std::array<PropertyUse, 0> properties{};
  using PointFields<Derived>::directions;

  explicit PointKernel(Domain domain, std::vector<PropertyConstant> constants = {})
      : Kernel(std::move(domain), {Derived::uses.begin(), Derived::uses.end()},
               {Derived::properties.begin(), Derived::properties.end()}, std::move(constants)) {
    static_assert(all_described(Derived::uses),
                  "uses is longer than the list of fields given to it");
  }

  int dimension() const override { return Derived::dimension; }
  std::vector<CellShape> shapes() const override { return body_shapes(Derived::dimension); }

  void bind(const CellTabulation& table) override {
    detail::check_domain(*this, Derived::on_facets);
    detail::check_size(*this, table);
    this->table_ = table;
    own_properties().bind(table, fields());
  }
  int nodes(std::size_t field) const override { return this->table_.fields[field].nodes; }

  CellStatus residual(const CellInput& cell, double* residual) const override {
    return evaluate<double, double>(cell, residual, nullptr);
  }
  CellStatus tangent(const CellInput& cell, double* residual, double* tangent) const override {
    constexpr int supplied_directions = detail::components(Derived::properties);
    if constexpr (supplied_directions > 0)
      if (supplies().supplied()) {
        using T = Sacado::Fad::SFad<double, directions() + supplied_directions>;
        return evaluate<T, T>(cell, residual, tangent);
      }
    return evaluate<Sacado::Fad::SFad<double, directions()>, double>(cell, residual, tangent);
  }

  int memory_per_cell() const override { return this->table_.rule.points * Derived::memory; }
  void advance_memory(const CellInput& cell, double* next) const override;

 protected:
  /// visit(at, weight, q, gradients) at every quadrature point, in doubles: the weight is the
  /// reference volume of the point, m^dimension, gradients[field][node][k] those of the shapes,
  /// 1/m.
  template <class Visit>
  void at_points(const CellInput& cell, Visit&& visit) const;

 private:
  template <class At>
  double weight(int q, const At& at) const {
    const double weight = this->table_.rule.weights[static_cast<std::size_t>(q)];
    return Derived::on_facets ? weight : weight * at.determinant;
  }

  template <class T, class Index>
  struct FormOf;
  template <class T, std::size_t... I>
  struct FormOf<T, std::index_sequence<I...>> {
    std::tuple<FormAtPoint<T, Derived::uses[I].components, Derived::dimension,
                           has_rows(Derived::uses[I].role)>...>
        fields;
    bool inverted = false;
    template <int S>
    auto& operator[](Slot<S> /*slot*/) {
      static_assert(0 <= S && S < static_cast<int>(sizeof...(I)),
                    "this slot is beyond the kernel's uses");
      return std::get<S>(fields);
    }
  };

  const KernelProperties& supplies() const { return Kernel::properties(); }
  /// Properties at point q, as evaluated on the cell; independent variables after those of the
  /// fields.
  template <class P, class At>
  void load_properties(int q, At& at) const;
  template <class T, class P>
  CellStatus evaluate(const CellInput& cell, double* residual, double* tangent) const;
};

}  // namespace hawser

#include "hawser/physics/point_kernel_impl.hpp"
