#include "hawser/replay/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

using Column = std::vector<double>;
using Matrix = std::vector<Column>;  // [row][column]

constexpr int most_iterations = 15, most_halvings = 6;
constexpr double enough = 1e-5;  // relative change of the sum of squares
constexpr double alike = 0.9;    // cosine or correlation of what can hardly be told apart

/// Measured minus model, [shot][receiver][east, north] without the missing ones.
Column residuals(const MeasuredLine& line, const Positions& model) {
  Column result;
  for (std::size_t s = 0; s < line.places.size(); ++s)
    for (std::size_t r = 0; r < line.places[s].size(); ++r)
      if (is_known(line.places[s][r]))
        for (std::size_t j = 0; j < 2; ++j)
          result.push_back(line.places[s][r][j] - model[s][r][j]);
  return result;
}

double dot(const Column& a, const Column& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

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

/// How many neighbours in a row say the same thing: 1 + 2 (sum of the correlations until they end),
/// of series residual(series, place), NaN where there is none.
template <class Residual>
double correlation_length(std::size_t series, std::size_t places, const Residual& residual) {
  double variance = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < series; ++i)
    for (std::size_t p = 0; p < places; ++p)
      if (const double r = residual(i, p); !std::isnan(r)) {
        variance += r * r;
        ++count;
      }
  if (count == 0 || variance == 0) return 1;
  variance /= static_cast<double>(count);
  double length = 1;
  for (std::size_t lag = 1; lag < places; ++lag) {
    double sum = 0;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < series; ++i)
      for (std::size_t p = 0; p + lag < places; ++p) {
        const double product = residual(i, p) * residual(i, p + lag);
        if (std::isnan(product)) continue;
        sum += product;
        ++pairs;
      }
    const double correlation = pairs == 0 ? 0 : sum / static_cast<double>(pairs) / variance;
    if (correlation <= 0) break;
    length += 2 * correlation * (1 - static_cast<double>(lag) / static_cast<double>(places));
  }
  return length;
}

/// Numbers that count as independent, of those that there are.
double independent_count(const MeasuredLine& line, const Positions& model, std::size_t numbers) {
  const std::size_t shots = line.places.size(), receivers = line.receivers.size();
  const auto residual = [&](std::size_t s, std::size_t r, std::size_t j) {
    return line.places[s][r][j] - model[s][r][j];
  };
  const double along_line =
      correlation_length(2 * receivers, shots,
                         [&](std::size_t i, std::size_t s) { return residual(s, i / 2, i % 2); });
  const double along_cable =
      correlation_length(2 * shots, receivers,
                         [&](std::size_t i, std::size_t r) { return residual(i / 2, r, i % 2); });
  return std::max(1.0, static_cast<double>(numbers) / (along_line * along_cable));
}

/// d(model)/d(parameter), per unit of it, at the places that were measured.
Column difference(const MeasuredLine& line, const Column& at, const std::vector<double>& values,
                  std::size_t p, const ReplayParameter& parameter, const ReplayModel& model) {
  std::vector<double> changed = values;
  // Into the allowed range, and less than half of what is there.
  const double change = std::max(parameter.change, 0.02 * std::abs(values[p]));
  changed[p] += values[p] + change > parameter.most ? -change : change;
  Column column = residuals(line, model(changed));
  for (std::size_t i = 0; i < column.size(); ++i)
    column[i] = (at[i] - column[i]) / (changed[p] - values[p]);
  return column;
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
    const double numbers = static_cast<double>(off_.size());
    result_.independent = independent_count(line_, result_.positions, off_.size());
    Matrix normal(n, Column(n));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        normal[i][j] = dot(columns_[i], columns_[j]);
    const Matrix inverted = inverse(normal);
    // sigma^2 (J^T J)^-1 numbers / independent, sigma^2 of one number.
    const double variance = squares() / result_.independent;
    result_.correlations.assign(n, Column(n, no_value));
    for (std::size_t i = 0; i < n; ++i) {
      result_.standard_errors.push_back(inverted.empty() ? no_value
                                                         : std::sqrt(variance * inverted[i][i]));
      result_.effects.push_back(std::sqrt(2 * normal[i][i] / numbers) * result_.standard_errors[i]);
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

std::vector<std::vector<double>> likeness(const MeasuredLine& line, const Positions& positions,
                                          const std::vector<ReplayParameter>& parameters,
                                          const std::vector<double>& values,
                                          const ReplayModel& model) {
  const Column at = residuals(line, positions);
  Matrix columns;
  for (std::size_t p = 0; p < parameters.size(); ++p)
    columns.push_back(difference(line, at, values, p, parameters[p], model));
  Matrix cosines(parameters.size(), Column(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (std::size_t j = 0; j < parameters.size(); ++j)
      cosines[i][j] = dot(columns[i], columns[j]) /
                      std::sqrt(dot(columns[i], columns[i]) * dot(columns[j], columns[j]));
  return cosines;
}

std::vector<std::string> what_cannot_be_told(const std::vector<ReplayParameter>& fitted,
                                             const FitResult& result,
                                             const std::vector<ReplayParameter>& all,
                                             const std::vector<std::vector<double>>& cosines) {
  std::vector<std::string> told;
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const double value = result.values[i], error = result.standard_errors[i];
    if (result.at_bound[i])
      told.push_back(fmt::format("{} is as far as it may go, at {:.4g}{}.", fitted[i].name, value,
                                 fitted[i].unit == "1" ? "" : " " + fitted[i].unit));
    else if (std::isnan(error))
      told.push_back(fmt::format("{} makes no difference on this line.", fitted[i].name));
    else if (std::abs(value) < 2 * error)
      told.push_back(fmt::format("{} is not told from 0: {:.3g} +- {:.2g}{}.", fitted[i].name,
                                 value, error, fitted[i].unit == "1" ? "" : " " + fitted[i].unit));
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(result.correlations[i][j]) > alike)
        told.push_back(
            fmt::format("{} and {} cannot be told apart from this line: the errors of the "
                        "two have a correlation of {:.3f}.",
                        fitted[j].name, fitted[i].name, result.correlations[i][j]));
  }
  const auto is_fitted = [&](const ReplayParameter& p) {
    return std::any_of(fitted.begin(), fitted.end(),
                       [&](const ReplayParameter& f) { return f.name == p.name; });
  };
  // Of each that was held, the fitted one that it resembles most.
  for (std::size_t j = 0; j < all.size(); ++j) {
    std::size_t like = all.size();
    for (std::size_t i = 0; i < all.size() && !is_fitted(all[j]); ++i)
      if (is_fitted(all[i]) && std::abs(cosines[i][j]) > alike &&
          (like == all.size() || std::abs(cosines[i][j]) > std::abs(cosines[like][j])))
        like = i;
    if (like < all.size())
      told.push_back(
          fmt::format("{} was held, and moves the receivers as {} does (cosine {:.3f}): "
                      "what was found for {} stands for both.",
                      all[j].name, all[like].name, cosines[like][j], all[like].name));
  }
  return told;
}

}  // namespace hawser
