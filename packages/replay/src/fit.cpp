#include "hawser/replay/fit.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "src/independence.hpp"
#include "src/sensitivity.hpp"

namespace hawser {
namespace {

constexpr int most_iterations = 15, most_halvings = 6;
constexpr double enough = 1e-5;  // relative change of the sum of squares

/// The inverse of a symmetric positive matrix, by Cholesky of what it is with a unit diagonal;
/// empty when it is singular.
Matrix inverse(const Matrix& a) {
  const std::size_t n = a.size();
  Matrix lower(n, Column(n, 0)), result(n, Column(n, 0));
  Column scale(n);
  for (std::size_t i = 0; i < n; ++i)
    scale[i] = std::sqrt(a[i][i]);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = a[i][j] / (scale[i] * scale[j]);
      for (std::size_t k = 0; k < j; ++k)
        sum -= lower[i][k] * lower[j][k];
      if (i == j && !(sum > 1e-12)) return {};
      lower[i][j] = i == j ? std::sqrt(sum) : sum / lower[j][j];
    }
  for (std::size_t c = 0; c < n; ++c) {
    Column x(n, 0);
    x[c] = 1;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < i; ++k)
        x[i] -= lower[i][k] * x[k];
      x[i] /= lower[i][i];
    }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = i + 1; k < n; ++k)
        x[i] -= lower[k][i] * x[k];
      x[i] /= lower[i][i];
    }
    for (std::size_t i = 0; i < n; ++i)
      result[i][c] = x[i] / (scale[i] * scale[c]);
  }
  return result;
}

class Fitting {
 public:
  Fitting(const MeasuredLine& line, const std::vector<ReplayParameter>& parameters,
          const ReplayModel& model, const std::function<void(const FitIteration&)>& told)
      : line_(line), parameters_(parameters), model_(model), told_(told) {}

  FitResult fit(std::vector<double> start) {
    result_.values = std::move(start);
    result_.positions = model_(result_.values);
    off_ = residuals(line_, result_.positions);
    remember();
    for (int i = 0; i < most_iterations && !result_.converged; ++i)
      iterate();
    judge();
    return std::move(result_);
  }

 private:
  double squares() const { return dot(off_, off_); }
  void remember() {
    result_.iterations.push_back(
        {result_.values, std::sqrt(2 * squares() / static_cast<double>(off_.size()))});
    told_(result_.iterations.back());
  }

  void differentiate() {
    columns_.clear();
    for (std::size_t p = 0; p < parameters_.size(); ++p)
      columns_.push_back(difference(line_, off_, result_.values, p, parameters_[p], model_));
  }

  void iterate() {
    differentiate();
    const std::size_t n = parameters_.size();
    // Parameters that stand at a bound and would go beyond it stay there.
    std::vector<std::size_t> free;
    for (std::size_t p = 0; p < n; ++p) {
      const double slope = dot(columns_[p], off_);
      const bool low = result_.values[p] <= parameters_[p].least && slope <= 0;
      const bool high = result_.values[p] >= parameters_[p].most && slope >= 0;
      if (!low && !high && dot(columns_[p], columns_[p]) > 0) free.push_back(p);
    }
    Matrix normal(free.size(), Column(free.size()));
    Column right;
    for (std::size_t i = 0; i < free.size(); ++i) {
      right.push_back(dot(columns_[free[i]], off_));
      for (std::size_t j = 0; j < free.size(); ++j)
        normal[i][j] = dot(columns_[free[i]], columns_[free[j]]);
    }
    const Matrix inverted = inverse(normal);
    if (inverted.empty()) return void(result_.converged = true);  // nothing to be gained
    std::vector<double> change(n, 0);
    for (std::size_t i = 0; i < free.size(); ++i)
      change[free[i]] = dot(inverted[i], right);
    const double before = squares();
    for (int halving = 0; halving < most_halvings; ++halving) {
      std::vector<double> tried = result_.values;
      for (std::size_t p = 0; p < n; ++p)
        tried[p] = std::clamp(tried[p] + change[p], parameters_[p].least, parameters_[p].most);
      if (attempt(tried, before)) {
        result_.converged = before - squares() < enough * before;
        return remember();
      }
      for (double& c : change)
        c /= 2;
    }
    result_.converged = true;  // no way down
  }

  bool attempt(const std::vector<double>& values, double before) {
    Positions positions;
    try {
      positions = model_(values);
    } catch (const SolveError&) {
      return false;
    }
    Column off = residuals(line_, positions);
    if (!(dot(off, off) < before)) return false;
    result_.values = values;
    result_.positions = std::move(positions);
    off_ = std::move(off);
    return true;
  }

  void judge() {
    differentiate();
    const std::size_t n = parameters_.size();
    result_.independent = independent_count(line_, result_.positions, off_.size());
    Matrix normal(n, Column(n));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        normal[i][j] = dot(columns_[i], columns_[j]);
    const Matrix inverted = inverse(normal);
    // sigma^2 (J^T J)^-1 n / n_independent, sigma^2 of one number.
    const double variance = squares() / result_.independent;
    result_.correlations.assign(n, Column(n, no_value));
    for (std::size_t i = 0; i < n; ++i) {
      result_.standard_errors.push_back(inverted.empty() ? no_value
                                                         : std::sqrt(variance * inverted[i][i]));
      result_.at_bound.push_back(result_.values[i] <= parameters_[i].least ||
                                 result_.values[i] >= parameters_[i].most);
      for (std::size_t j = 0; j < n && !inverted.empty(); ++j)
        result_.correlations[i][j] = inverted[i][j] / std::sqrt(inverted[i][i] * inverted[j][j]);
    }
  }

  const MeasuredLine& line_;
  const std::vector<ReplayParameter>& parameters_;
  const ReplayModel& model_;
  const std::function<void(const FitIteration&)>& told_;
  FitResult result_;
  Column off_;      // measured minus model
  Matrix columns_;  // d(model)/d(parameter)
};

}  // namespace

FitResult fit_parameters(const MeasuredLine& line, const std::vector<ReplayParameter>& parameters,
                         std::vector<double> start, const ReplayModel& model,
                         const std::function<void(const FitIteration&)>& told) {
  return Fitting(line, parameters, model, told).fit(std::move(start));
}

}  // namespace hawser
