#include "hawser/assembly/constraints.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {

Constraints::Constraints(Assembler& assembler)
    : assembler_(assembler), prescribed_(static_cast<std::size_t>(assembler.dofs().owned()), -1) {}

void Constraints::prescribe(std::vector<PrescribedRow> rows) {
  rows_ = std::move(rows);
  std::fill(prescribed_.begin(), prescribed_.end(), -1);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    prescribed_[static_cast<std::size_t>(rows_[i].row)] = static_cast<int>(i);
}

// Where the velocity is prescribed there is no balance that could find the displacement.
bool Constraints::finds_displacement(const Assembler::KinematicPair& pair,
                                     const Kinematics& kinematics) const {
  return kinematics.at_rest && prescribed_[static_cast<std::size_t>(pair.velocity)] < 0;
}

void Constraints::apply(const State& state, const Kinematics& kinematics,
                        std::vector<double>& residual, std::vector<double>& magnitude) const {
  const auto& pairs = assembler_.kinematic_pairs();
  const auto set = [&](LocalIndex row, double left, double right) {
    residual[static_cast<std::size_t>(row)] = left - right;
    magnitude[static_cast<std::size_t>(row)] = std::abs(left) + std::abs(right);
  };
  const auto value = [&](LocalIndex row) { return state.value[static_cast<std::size_t>(row)]; };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [displacement, velocity] = pairs[i];
    if (displacement >= assembler_.dofs().owned()) continue;
    const double right = kinematics.known[i] + kinematics.factor * value(velocity);
    if (finds_displacement(pairs[i], kinematics)) {
      // v = 0, or that of the drift: the way made in a second, judged against the displacement.
      const auto component = static_cast<std::size_t>(assembler_.dofs().info(velocity).component);
      const double drift = state.drift[component];
      residual[static_cast<std::size_t>(displacement)] = value(velocity) - drift;
      magnitude[static_cast<std::size_t>(displacement)] =
          std::abs(value(velocity)) + std::abs(drift) + std::abs(value(displacement)) +
          std::abs(right);
    } else {
      set(displacement, value(displacement), right);
    }
  }
  for (const PrescribedRow& row : rows_)
    set(row.row, value(row.row), row.value);
}

void Constraints::apply(const Kinematics& kinematics) {
  const auto replace = [&](LocalIndex row, LocalIndex column, double entry, bool clear) {
    double* const values = assembler_.row_values(row);
    const LocalIndex* const columns = assembler_.row_columns(row);
    const int size = assembler_.row_size(row);
    if (clear) std::fill(values, values + size, 0.0);
    const LocalIndex* const found = std::lower_bound(columns, columns + size, column);
    if (found != columns + size && *found == column) values[found - columns] += entry;
  };
  RowLayout& layout = assembler_.system().layout;
  layout.factor = kinematics.factor;
  layout.ordered = true;
  layout.prescribed.assign(prescribed_.size(), 0);
  const auto& pairs = assembler_.kinematic_pairs();
  for (const auto& pair : pairs) {
    if (pair.displacement >= assembler_.dofs().owned()) continue;
    if (finds_displacement(pair, kinematics)) {
      layout.ordered = false;
      replace(pair.displacement, pair.velocity, 1, true);
      continue;
    }
    replace(pair.displacement, pair.displacement, 1, true);
    replace(pair.displacement, pair.velocity, -kinematics.factor, false);
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const PrescribedRow& row = rows_[i];
    if (prescribed_[static_cast<std::size_t>(row.row)] != static_cast<int>(i))
      continue;  // a later one rules
    replace(row.row, row.row, 1, true);
    layout.prescribed[static_cast<std::size_t>(row.row)] = 1;
    const NodeDisplacement& moved = row.displacement;
    for (int k = 0; k < moved.count; ++k)
      for (int j = 0; j < assembler_.dofs().mesh().dimension; ++j)
        replace(row.row, moved.first[k] + j, -moved.weight * row.slope[j], false);
  }
}

}  // namespace hawser
