#include "src/sensitivity.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {

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

}  // namespace hawser
