#pragma once
// The quadrature loop behind PointKernel. Included by point_kernel.hpp only.

namespace hawser {

template <class Derived>
template <class P, class At>
void PointKernel<Derived>::load_properties(int q, At& at) const {
  if constexpr (!Derived::properties.empty()) {
    const double* values = supplies().values(q);
    int direction = directions();
    detail::for_each_index(std::make_index_sequence<Derived::properties.size()>{}, [&](auto index) {
      for (int c = 0; c < Derived::properties[index].components; ++c)
        detail::entry(std::get<index>(at.properties.all), c) =
            detail::Number<P>::independent(direction++, *values++);
    });
  }
}

template <class Derived>
template <class Visit>
void PointKernel<Derived>::at_points(const CellInput& cell, Visit&& visit) const {
  auto at = this->template point<double, double>();
  detail::ShapeGradients<Derived> gradients;
  this->enter(cell, at);
  supplies().evaluate(cell, false);
  for (int q = 0; q < this->table_.rule.points; ++q) {
    this->go_to(q, cell, at, gradients);
    load_properties<double>(q, at);
    visit(at, weight(q, at), q, std::as_const(gradients));
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
template <class T, class P>
CellStatus PointKernel<Derived>::evaluate(const CellInput& cell, double* residual,
                                          double* tangent) const {
  constexpr int D = Derived::dimension;
  using Indices = std::make_index_sequence<Derived::uses.size()>;
  using Num = detail::Number<T>;
  constexpr bool with_slopes = !std::is_same_v<P, double>;

  const auto offset = this->offsets();
  const int own = offset.back();
  const int n = supplies().supplied() ? supplies().unknowns() : own;
  std::fill(residual, residual + n, 0.0);
  if (tangent != nullptr) std::fill(tangent, tangent + n * n, 0.0);

  auto at = this->template point<T, P>();
  this->enter(cell, at);
  if (!supplies().evaluate(cell, with_slopes)) return CellStatus::inverted;

  const Quadrature& rule = this->table_.rule;
  detail::ShapeGradients<Derived> gradients;
  for (int q = 0; q < rule.points; ++q) {
    this->go_to(q, cell, at, gradients);
    if (q == 0 || supplies().supplied()) load_properties<P>(q, at);
    const double weight = this->weight(q, at);

    FormOf<T, Indices> out;
    static_cast<const Derived&>(*this).weak_form(at, out);
    if (out.inverted) return CellStatus::inverted;

    const auto contract_columns = [&](const T& output, double* line) {
      std::fill(line, line + n, 0.0);
      if constexpr (!std::is_same_v<T, double>) {
        const double* const derivative = &output.fastAccessDx(0);
        this->contract(q, cell, gradients, offset, derivative, line);
        if constexpr (with_slopes) {
          const double* slope = supplies().slopes(q);
          for (int k = 0; k < supplies().components(); ++k, slope += n) {
            const double factor = derivative[directions() + k];
            if (factor == 0) continue;
            for (int j = 0; j < n; ++j)
              line[j] += factor * slope[j];
          }
        }
      }
    };

    detail::for_each_index(Indices{}, [&](auto index) {
      constexpr std::size_t f = index;
      constexpr int components = Derived::uses[f].components;
      if constexpr (has_rows(Derived::uses[f].role)) {
        const double* const N = &this->table_.fields[f].values[q * this->table_.fields[f].nodes];
        const int nodes = this->table_.fields[f].nodes;
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
