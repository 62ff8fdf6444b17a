#pragma once
// The quadrature loop behind PointKernel. Included by point_kernel.hpp only.

namespace hawser {
namespace detail {

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

}  // namespace detail

template <class Derived>
template <class At>
void PointKernel<Derived>::enter(const CellInput& cell, At& at) const {
  at.time = cell.time;
  at.step = cell.step;
  at.elapsed = cell.elapsed;
  at.CellGeometry<Derived::dimension>::enter(table_, cell.coordinates);
}

template <class Derived>
template <class At, class Gradients>
void PointKernel<Derived>::go_to(int q, const CellInput& cell, At& at, Gradients& gradients) const {
  constexpr int D = Derived::dimension;
  using Indices = std::make_index_sequence<Derived::uses.size()>;
  using Num = detail::Number<typename At::Number>;
  at.CellGeometry<D>::go_to(q, table_, cell.coordinates);
  at.memory = cell.memory + q * Derived::memory;
  int direction = 0;
  detail::for_each_index(Indices{}, [&](auto index) {
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
template <class Visit>
void PointKernel<Derived>::at_points(const CellInput& cell, Visit&& visit) const {
  PointOf<double, std::make_index_sequence<Derived::uses.size()>> at;
  detail::ShapeGradients<Derived> gradients;
  enter(cell, at);
  for (int q = 0; q < table_.rule.points; ++q) {
    go_to(q, cell, at, gradients);
    visit(at, table_.rule.weights[q] * at.determinant, q, std::as_const(gradients));
  }
}

template <class Derived>
void PointKernel<Derived>::advance_memory(const CellInput& cell, double* next) const {
  if constexpr (Derived::memory > 0)
    at_points(cell, [&](const auto& at, double /*weight*/, int q, const auto& /*gradients*/) {
      static_cast<const Derived&>(*this).advance(at, next + q * Derived::memory);
    });
}

template <class Derived>
template <class T>
CellStatus PointKernel<Derived>::evaluate(const CellInput& cell, double* residual,
                                          double* tangent) const {
  constexpr int D = Derived::dimension;
  constexpr std::size_t field_count = Derived::uses.size();
  using Indices = std::make_index_sequence<field_count>;
  using Num = detail::Number<T>;

  std::array<int, field_count + 1> offset{};  // first unknown of each field
  for (std::size_t f = 0; f < field_count; ++f)
    offset[f + 1] = offset[f] + table_.fields[f].nodes * Derived::uses[f].components;
  const int n = offset[field_count];
  std::fill(residual, residual + n, 0.0);
  if (tangent != nullptr) std::fill(tangent, tangent + n * n, 0.0);

  PointOf<T, Indices> at;
  enter(cell, at);

  const Quadrature& rule = table_.rule;
  detail::ShapeGradients<Derived> gradients;
  for (int q = 0; q < rule.points; ++q) {
    go_to(q, cell, at, gradients);
    const double weight = rule.weights[q] * at.determinant;

    FormOf<T, Indices> out;
    static_cast<const Derived&>(*this).weak_form(at, out);
    if (out.inverted) return CellStatus::inverted;

    // One line of the point Jacobian times the shapes of all columns.
    const auto contract_columns = [&](const T& output, double* line) {
      std::fill(line, line + n, 0.0);
      if constexpr (!std::is_same_v<T, double>) {
        const double* const derivative = &output.fastAccessDx(0);
        int first = 0;
        detail::for_each_index(Indices{}, [&](auto index) {
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
    };

    detail::for_each_index(Indices{}, [&](auto index) {
      constexpr std::size_t f = index;
      constexpr int components = Derived::uses[f].components;
      constexpr Role role = Derived::uses[f].role;
      if constexpr (role == Role::adds || role == Role::governs) {
        const double* const N = &table_.fields[f].values[q * table_.fields[f].nodes];
        const int nodes = table_.fields[f].nodes;
        double line[2 * detail::max_unknowns];
        auto& form = std::get<f>(out.fields);
        const auto scatter = [&](const T& output, int c, auto&& test) {
          const double value = weight * Num::value(output);
          for (int a = 0; a < nodes; ++a)
            residual[offset[f] + a * components + c] += test(a) * value;
          if (tangent == nullptr) return;
          contract_columns(output, line);
          for (int a = 0; a < nodes; ++a) {
            double* const row = tangent + (offset[f] + a * components + c) * n;
            const double factor = weight * test(a);
            for (int j = 0; j < n; ++j)
              row[j] += factor * line[j];
          }
        };
        for (int c = 0; c < components; ++c) {
          scatter(detail::entry(form.source, c), c, [&](int a) { return N[a]; });
          for (int j = 0; j < D; ++j)
            scatter(detail::gradient_entry(form.flux, c, j), c,
                    [&, j](int a) { return gradients[f][a][j]; });
        }
      }
    });
  }
  double sum = 0;
  for (int i = 0; i < n; ++i)
    sum += residual[i];
  return std::isfinite(sum) ? CellStatus::ok : CellStatus::not_finite;
}

}  // namespace hawser
