#include "hawser/report/force.hpp"

#include <cmath>

namespace hawser {

Force split_force(const std::vector<double>& force, const std::vector<double>& axis) {
  double squared = 0, length = 0, along = 0;
  for (std::size_t j = 0; j < axis.size(); ++j) {
    squared += force[j] * force[j];
    length += axis[j] * axis[j];
    along += force[j] * axis[j];
  }
  length = std::sqrt(length);
  Force result{along / length, 0, std::sqrt(squared)};
  if (axis.size() == 2) {
    result.across = (-force[0] * axis[1] + force[1] * axis[0]) / length;
    return result;
  }
  double across = 0;
  for (std::size_t j = 0; j < axis.size(); ++j)
    across += std::pow(force[j] - result.along * axis[j] / length, 2);
  result.across = std::sqrt(across);
  return result;
}

std::vector<Column> force_columns(const std::string& name, const Mesh& mesh) {
  const std::string unit = mesh.force_unit();
  return {{name + "_force", unit}, {name + "_force_along", unit}, {name + "_force_across", unit}};
}

}  // namespace hawser
