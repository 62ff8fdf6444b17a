#include "anderson.hpp"

namespace hawser {

void Anderson::advance(const TpetraVector& residual, const TpetraVector& update, TpetraVector& x) {
  TpetraVector target(x, Teuchos::Copy);
  target.update(1.0, update, 1.0);
  Pair now{TpetraVector(residual, Teuchos::Copy), target};
  if (last_) {
    last_->residual.update(1.0, now.residual, -1.0);
    last_->target.update(1.0, now.target, -1.0);
    history_.push_front(std::move(*last_));
    if (history_.size() > depth_) history_.pop_back();
  }
  x.update(1.0, target, 0.0);
  const auto weights = least_squares(residual);
  for (std::size_t i = 0; i < weights.size(); ++i)
    x.update(-weights[i], history_[i].target, 1.0);
  last_ = std::move(now);
}

// Gram-Schmidt from the newest difference to the oldest. A difference that the newer ones nearly
// span adds noise only, and gets no weight.
std::vector<double> Anderson::least_squares(const TpetraVector& residual) const {
  constexpr double nearly_spanned = 1e-6;
  const std::size_t n = history_.size();
  std::vector<TpetraVector> basis;
  std::vector<std::size_t> used;              // history index of each basis vector
  std::vector<std::vector<double>> triangle;  // triangle[j][i]: part of basis i in difference j
  std::vector<double> rhs, weights(n, 0.0);
  TpetraVector rest(residual, Teuchos::Copy);
  for (std::size_t j = 0; j < n; ++j) {
    TpetraVector column(history_[j].residual, Teuchos::Copy);
    const double size = column.norm2();
    std::vector<double> parts;
    for (const auto& direction : basis) {
      parts.push_back(direction.dot(column));
      column.update(-parts.back(), direction, 1.0);
    }
    const double remaining = column.norm2();
    if (!(remaining > nearly_spanned * size)) continue;
    column.scale(1 / remaining);
    parts.push_back(remaining);
    rhs.push_back(column.dot(rest));
    rest.update(-rhs.back(), column, 1.0);
    basis.push_back(column);
    used.push_back(j);
    triangle.push_back(std::move(parts));
  }
  for (std::size_t i = basis.size(); i-- > 0;) {
    double value = rhs[i];
    for (std::size_t j = i + 1; j < basis.size(); ++j)
      value -= triangle[j][i] * weights[used[j]];
    weights[used[i]] = value / triangle[i][i];
  }
  return weights;
}

}  // namespace hawser
