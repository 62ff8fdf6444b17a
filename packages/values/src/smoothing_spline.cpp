#include "hawser/values/smoothing_spline.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/base/constants.hpp"

namespace hawser {
namespace {

/// Solves for x in place; the matrix has the diagonal a and, beside it, b and c, and is destroyed.
void solve_pentadiagonal(std::vector<double>& a, std::vector<double>& b, std::vector<double>& c,
                         std::vector<double>& x) {
  const std::size_t n = a.size();
  for (std::size_t i = 0; i < n; ++i) {  // L D L^T; b and c become L
    if (i > 0) a[i] -= b[i - 1] * b[i - 1] * a[i - 1];
    if (i > 1) a[i] -= c[i - 2] * c[i - 2] * a[i - 2];
    if (i > 0 && i + 1 < n) b[i] -= c[i - 1] * b[i - 1] * a[i - 1];
    if (i + 1 < n) b[i] /= a[i];
    if (i + 2 < n) c[i] /= a[i];
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) x[i] -= b[i - 1] * x[i - 1];
    if (i > 1) x[i] -= c[i - 2] * x[i - 2];
  }
  for (std::size_t i = 0; i < n; ++i)
    x[i] /= a[i];
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n) x[i] -= b[i] * x[i + 1];
    if (i + 2 < n) x[i] -= c[i] * x[i + 2];
  }
}

}  // namespace

SmoothingSpline::SmoothingSpline(const std::vector<double>& times,
                                 const std::vector<double>& values, double period)
    : times_(times), values_(values), curvatures_(times.size(), 0) {
  if (times.size() < 3) return;
  const std::size_t n = times.size(), inner = n - 2;
  const double lambda = std::pow(period / (2 * pi), 4);
  std::vector<double> h(n - 1), share(n);  // share: lambda over the weight
  for (std::size_t i = 0; i + 1 < n; ++i)
    h[i] = times[i + 1] - times[i];
  for (std::size_t i = 0; i < n; ++i)
    share[i] = lambda * 2 / ((i > 0 ? h[i - 1] : 0) + (i + 1 < n ? h[i] : 0));
  // (R + lambda Q^T W^-1 Q) curvatures = Q^T values; column j of Q holds second differences at j +
  // 1.
  const auto before = [&](std::size_t j) { return 1 / h[j]; };
  const auto after = [&](std::size_t j) { return 1 / h[j + 1]; };
  const auto at = [&](std::size_t j) { return -before(j) - after(j); };
  std::vector<double> a(inner), b(inner, 0), c(inner, 0), x(inner);
  for (std::size_t j = 0; j < inner; ++j) {
    a[j] = (h[j] + h[j + 1]) / 3 + share[j] * before(j) * before(j) + share[j + 1] * at(j) * at(j) +
           share[j + 2] * after(j) * after(j);
    if (j + 1 < inner)
      b[j] =
          h[j + 1] / 6 + share[j + 1] * at(j) * before(j + 1) + share[j + 2] * after(j) * at(j + 1);
    if (j + 2 < inner) c[j] = share[j + 2] * after(j) * before(j + 2);
    x[j] = (values[j + 2] - values[j + 1]) / h[j + 1] - (values[j + 1] - values[j]) / h[j];
  }
  solve_pentadiagonal(a, b, c, x);
  std::copy(x.begin(), x.end(), curvatures_.begin() + 1);
  for (std::size_t j = 0; j < inner; ++j) {
    values_[j] -= share[j] * before(j) * x[j];
    values_[j + 1] -= share[j + 1] * at(j) * x[j];
    values_[j + 2] -= share[j + 2] * after(j) * x[j];
  }
}

std::size_t SmoothingSpline::piece(double time) const {
  const auto above = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
  return static_cast<std::size_t>(above - times_.begin()) - 1;
}

double SmoothingSpline::value(double time) const {
  const std::size_t i = piece(time);
  const double h = times_[i + 1] - times_[i];
  const double u = (time - times_[i]) / h, v = 1 - u;
  return v * values_[i] + u * values_[i + 1] -
         h * h / 6 * u * v * ((1 + v) * curvatures_[i] + (1 + u) * curvatures_[i + 1]);
}

double SmoothingSpline::rate(double time) const {
  const std::size_t i = piece(time);
  const double h = times_[i + 1] - times_[i];
  const double u = (time - times_[i]) / h, v = 1 - u;
  return (values_[i + 1] - values_[i]) / h +
         h / 6 * ((1 - 3 * v * v) * curvatures_[i] + (3 * u * u - 1) * curvatures_[i + 1]);
}

}  // namespace hawser
