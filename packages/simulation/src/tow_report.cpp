#include "src/tow_report.hpp"

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/physics/field_use.hpp"
#include "src/look_up.hpp"

namespace hawser {
namespace {
constexpr double degree = 3.14159265358979323846 / 180;
}

TowReport::TowReport(const DofMap& dofs, const TowDeck& deck, Diagnostics& diagnostics)
    : dofs_(dofs), deck_(deck), axis_(static_cast<std::size_t>(dofs.mesh().dimension), 0) {
  axis_[0] = std::sin(deck.angle * degree);
  axis_[1] = std::cos(deck.angle * degree);
  const Region* const cable = find_region_of(2, dofs.mesh(), deck.cable, "<tow>", diagnostics);
  const Region* const tow_point = find_point(dofs.mesh(), deck.tow_point, "<tow>", diagnostics);
  find_field(dofs, {field_name::velocity, deck.cable.location}, diagnostics);
  if (cable == nullptr || tow_point == nullptr) return;
  try {
    line_ = std::make_unique<LineGeometry>(dofs, *cable, *tow_point);
  } catch (const MeshError& error) {
    diagnostics.error(deck.cable.location, error.what());
  }
}

std::vector<double> TowReport::positioning_errors(const std::vector<double>& positions) const {
  std::vector<double> errors;
  const std::size_t dimension = axis_.size();
  for (std::size_t i = 0; i < positions.size(); i += dimension) {
    double along = 0;
    for (std::size_t j = 0; j < dimension; ++j)
      along += (positions[i + j] - positions[j]) * axis_[j];
    double squared = 0;
    for (std::size_t j = 0; j < dimension; ++j)
      squared += std::pow(positions[i + j] - positions[j] - along * axis_[j], 2);
    errors.push_back(std::sqrt(squared));
  }
  return errors;
}

TowMeasures TowReport::measure(const State& state, const std::vector<double>& reactions) const {
  TowMeasures result;
  const std::vector<double> x = line_->positions(state);
  const std::vector<double> errors = positioning_errors(x);
  const std::size_t dimension = axis_.size();
  result.end_error = errors.back();
  double integral = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    result.total_error += errors[i] / static_cast<double>(errors.size());
    if (i == 0) continue;
    double squared = 0;
    for (std::size_t j = dimension * i; j < dimension * (i + 1); ++j)
      squared += (x[j] - x[j - dimension]) * (x[j] - x[j - dimension]);
    const double segment = std::sqrt(squared);
    result.length += segment;
    integral += 0.5 * segment * (errors[i] + errors[i - 1]);
  }
  result.total_error_arc = integral / result.length;
  const std::size_t tail = x.size() - dimension;
  result.cable_angle = std::atan2(x[0] - x[tail], x[1] - x[tail + 1]) / degree;

  std::vector<double> force(dimension, 0);
  const int velocity = dofs_.find(field_name::velocity);
  for (const auto& node : line_->owned())
    if (node.place == 0)
      for (std::size_t j = 0; j < dimension; ++j)
        force[j] = reactions[static_cast<std::size_t>(
                                 dofs_.first_row(velocity, PointKind::vertex, node.vertex)) +
                             j];
  MPI_Allreduce(MPI_IN_PLACE, force.data(), static_cast<int>(dimension), MPI_DOUBLE, MPI_SUM,
                dofs_.mesh().communicator.mpi());
  result.force = split_force(force, axis_);
  return result;
}

double TowReport::exact_end_error(double length) const {
  // Relative to the water the cable moves with V along the axis and U against the current.
  const double angle = deck_.angle * degree;
  const double relative =
      std::atan2(deck_.speed * std::sin(angle), deck_.current + deck_.speed * std::cos(angle));
  return length * std::abs(std::sin(angle - relative));
}

}  // namespace hawser
