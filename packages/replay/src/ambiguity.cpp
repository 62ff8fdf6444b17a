// What a line does not tell of parameters, or tells of two only together.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/sensitivity.hpp"

namespace hawser {
namespace {

constexpr double alike = 0.9;  // cosine or correlation of what can hardly be told apart

}  // namespace

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
