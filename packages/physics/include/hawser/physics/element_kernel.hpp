#pragma once
// A line, boundary or structural term, written per element in its nodal unknowns.
#include <Sacado.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "hawser/physics/kernel.hpp"
#include "hawser/physics/point_fields.hpp"

namespace hawser {

namespace detail {
/// Shapes of all of the kernel's fields, one node per vertex, at the vertices of its element.
/// PluginError where that does not fill the space: no gradient is known there.
CellTabulation at_vertices(const Kernel& kernel, CellShape shape);
}  // namespace detail

/// Derived has:  static constexpr int dimension;
///               static constexpr CellShape shape;   (of a facet the triangle's, of a patch a
///               line's) static constexpr int node_count;    (of a cell: vertices) static constexpr
///               std::array<FieldUse, n> uses;   (each has a node per vertex) template <class
///               Element, class T> void element_residual(const Element& at, T* out) const;
/// One whose cells remember something hides
///               static constexpr int memory;   doubles per cell
/// reads at.memory(i) and has
///               template <class Element> void advance(const Element& at, double* next) const;
/// which is evaluated with doubles on acceptance (Kernel::advance_memory).
/// One that uses properties hides
///               static constexpr std::array<PropertyUse, m> properties;
/// and reads at.property(PropertySlot<i>, node, component). Others can supply them where the
/// element is a cell, or a facet with the cell behind it.
/// `out` is zeroed and ordered like the cell's unknowns: out[at.index(field, node, component)].
template <class Derived>
class ElementKernel : public Kernel {
 public:
  static constexpr int memory = 0;
  static constexpr std::array<PropertyUse, 0> properties{};

  explicit ElementKernel(Domain domain, std::vector<PropertyConstant> constants = {})
      : Kernel(std::move(domain), {Derived::uses.begin(), Derived::uses.end()},
               {Derived::properties.begin(), Derived::properties.end()}, std::move(constants)) {
    static_assert(all_described(Derived::uses),
                  "uses is longer than the list of fields given to it");
  }

  int dimension() const override { return Derived::dimension; }
  std::vector<CellShape> shapes() const override { return {Derived::shape}; }
  void bind(const CellTabulation& /*table*/) override {
    if (supplies().supplied())
      own_properties().bind(detail::at_vertices(*this, Derived::shape), fields());
  }
  int nodes(std::size_t /*field*/) const override { return Derived::node_count; }

  CellStatus residual(const CellInput& cell, double* residual) const override {
    std::fill(residual, residual + all_unknowns(), 0.0);
    if (!supplies().evaluate(cell, false)) return CellStatus::inverted;
    static_cast<const Derived&>(*this).element_residual(element(cell), residual);
    return status(residual);
  }

  CellStatus tangent(const CellInput& cell, double* residual, double* tangent) const override {
    constexpr int supplied_directions =
        Derived::node_count * detail::components(Derived::properties);
    if constexpr (supplied_directions > 0)
      if (supplies().supplied()) {
        using T = Sacado::Fad::SFad<double, unknowns() + supplied_directions>;
        return tangent_as<T, T>(cell, residual, tangent);
      }
    return tangent_as<Sacado::Fad::SFad<double, unknowns()>, double>(cell, residual, tangent);
  }

  int memory_per_cell() const override { return Derived::memory; }
  void advance_memory(const CellInput& cell, double* next) const override {
    if constexpr (Derived::memory > 0)
      static_cast<const Derived&>(*this).advance(element(cell), next);
  }

  static constexpr int first(int field) {
    int sum = 0;
    for (int f = 0; f < field; ++f)
      sum += Derived::node_count * Derived::uses[static_cast<std::size_t>(f)].components;
    return sum;
  }
  static constexpr int unknowns() { return first(static_cast<int>(Derived::uses.size())); }

 protected:
  /// T: the number of fields, P: that of properties.
  template <class T, class P = double>
  struct Element {
    explicit Element(const CellInput& input) : cell(&input) {}
    const CellInput* cell;
    // [node][component of all properties]
    P supplied[std::max(Derived::node_count * detail::components(Derived::properties), 1)];
    T values[unknowns()];
    T rates[unknowns()];

    static constexpr int index(int field, int node, int component) {
      return first(field) + node * Derived::uses[static_cast<std::size_t>(field)].components +
             component;
    }
    static constexpr int field_of(int unknown) {
      int f = 0;
      while (unknown >= first(f + 1))
        ++f;
      return f;
    }
    double nodal(int unknown, const double* FieldOnCell::*array) const {
      const int f = field_of(unknown);
      return (cell->fields[f].*array)[unknown - first(f)];
    }
    const T& value(int field, int node, int component) const {
      return values[index(field, node, component)];
    }
    const T& rate(int field, int node, int component) const {
      return rates[index(field, node, component)];
    }
    template <int S>
    const P& property(PropertySlot<S> /*slot*/, int node, int component = 0) const {
      static_assert(0 <= S && S < static_cast<int>(Derived::properties.size()),
                    "this slot is beyond the kernel's properties");
      return supplied[node * detail::components(Derived::properties) +
                      detail::components(Derived::properties, S) + component];
    }
    double elapsed() const { return cell->elapsed; }        ///< s, since the instant of the memory
    double memory(int i) const { return cell->memory[i]; }  ///< of the last accepted step
    double time() const { return cell->time; }              ///< s
    /// At the last accepted step.
    double accepted(int field, int node, int component) const {
      return nodal(index(field, node, component), &FieldOnCell::accepted);
    }
    /// At the end of the step.
    T end(int field, int node, int component) const {
      const T& now = value(field, node, component);
      if (cell->share == 1) return now;
      const double before = accepted(field, node, component);
      return before + (now - before) / cell->share;
    }
    /// Reference coordinate, m.
    double coordinate(int node, int component) const {
      return cell->coordinates[node * Derived::dimension + component];
    }
  };

  /// For what a kernel evaluates beside its residual.
  Element<double> element(const CellInput& cell) const {
    Element<double> at(cell);
    load_properties(at);
    for (int i = 0; i < unknowns(); ++i) {
      at.values[i] = at.nodal(i, &FieldOnCell::value);
      at.rates[i] = at.nodal(i, &FieldOnCell::rate);
    }
    return at;
  }

  /// Residual . value of a field, as of the momentum rows and the velocity.
  double residual_times(const CellInput& cell, int field) const {
    double out[detail::max_unknowns];
    residual(cell, out);
    double sum = 0;
    for (int i = first(field); i < first(field + 1); ++i)
      sum += out[i] * cell.fields[field].value[i - first(field)];
    return sum;
  }

 private:
  const KernelProperties& supplies() const { return Kernel::properties(); }
  int all_unknowns() const { return supplies().supplied() ? supplies().unknowns() : unknowns(); }

  /// As evaluated on the cell; independent variables after those of the fields.
  template <class T, class P>
  void load_properties(Element<T, P>& at) const {
    constexpr int count = detail::components(Derived::properties);
    for (int a = 0; count > 0 && a < Derived::node_count; ++a)
      for (int c = 0; c < count; ++c)
        at.supplied[a * count + c] =
            detail::Number<P>::independent(unknowns() + a * count + c, supplies().values(a)[c]);
  }

  template <class T, class P>
  CellStatus tangent_as(const CellInput& cell, double* residual, double* tangent) const {
    constexpr int n = unknowns();
    constexpr auto partners = rate_partners(Derived::uses);
    constexpr int count = detail::components(Derived::properties);
    constexpr bool with_slopes = !std::is_same_v<P, double>;
    const int all = all_unknowns();
    if (!supplies().evaluate(cell, with_slopes)) return CellStatus::inverted;
    Element<T, P> at(cell);
    load_properties(at);
    for (int i = 0; i < n; ++i) {
      at.values[i] = T(T().size(), i, at.nodal(i, &FieldOnCell::value));
      at.rates[i] = T(T().size(), i, at.nodal(i, &FieldOnCell::rate));
      at.rates[i].fastAccessDx(i) = at.nodal(i, &FieldOnCell::rate_slope);
      const int field = at.field_of(i);
      const int followed = partners[static_cast<std::size_t>(field)];
      if (followed >= 0)
        at.rates[i].fastAccessDx(first(followed) + i - first(field)) +=
            at.nodal(i, &FieldOnCell::rate_partner);
    }
    T out[n];
    for (int i = 0; i < n; ++i)
      out[i] = 0.0;
    static_cast<const Derived&>(*this).element_residual(at, out);
    std::fill(residual + n, residual + all, 0.0);
    std::fill(tangent, tangent + all * all, 0.0);
    for (int i = 0; i < n; ++i) {
      residual[i] = out[i].val();
      double* const row = tangent + i * all;
      for (int j = 0; j < n; ++j)
        row[j] = out[i].dx(j);
      if constexpr (with_slopes)
        for (int a = 0; a < Derived::node_count; ++a)
          for (int c = 0; c < count; ++c)
            for (int j = 0; j < all; ++j)
              row[j] += out[i].dx(n + a * count + c) * supplies().slopes(a)[c * all + j];
    }
    return status(residual);
  }

  static CellStatus status(const double* residual) {
    double sum = 0;
    for (int i = 0; i < unknowns(); ++i)
      sum += residual[i];
    return std::isfinite(sum) ? CellStatus::ok : CellStatus::not_finite;
  }
};

}  // namespace hawser
