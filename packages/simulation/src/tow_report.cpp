#include "src/tow_report.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/base/constants.hpp"
#include "hawser/base/error.hpp"
#include "hawser/fields/look_up.hpp"
#include "hawser/physics/field_use.hpp"

namespace hawser {
namespace {
constexpr double degree = pi / 180;
}

TowReport::TowReport(const DofMap& dofs, const TowDeck& deck, const Tracks& tracks,
                     Diagnostics& diagnostics)
    : dofs_(dofs), deck_(deck) {
  if (deck.track) track_ = find_track(tracks, *deck.track, diagnostics);
  const Region* const cable =
      find_region_of({CellShape::line}, dofs.mesh(), deck.cable, "<tow>", diagnostics);
  const Region* const tow_point = find_point(dofs.mesh(), deck.tow_point, "<tow>", diagnostics);
  find_field(dofs, {field_name::velocity, deck.cable.location}, diagnostics);
  if (cable == nullptr || tow_point == nullptr) return;
  try {
    line_ = std::make_unique<LineGeometry>(dofs, *cable, *tow_point);
  } catch (const MeshError& error) {
    diagnostics.error(deck.cable.location, error.what());
  }
}

std::vector<double> TowReport::axis(double time) const {
  std::vector<double> result(static_cast<std::size_t>(dofs_.mesh().dimension), 0);
  result[0] = std::sin(deck_.angle * degree);
  result[1] = std::cos(deck_.angle * degree);
  if (track_) {
    const auto course = track_->course(time);
    std::copy(course.begin(), course.end(), result.begin());
  }
  return result;
}

std::vector<double> TowReport::positioning_errors(const std::vector<double>& positions,
                                                  double time) const {
  const std::vector<double> axis_of_tow = axis(time);
  std::vector<double> errors;
  const std::size_t dimension = axis_of_tow.size();
  for (std::size_t i = 0; i < positions.size(); i += dimension) {
    double along = 0;
    for (std::size_t j = 0; j < dimension; ++j)
      along += (positions[i + j] - positions[j]) * axis_of_tow[j];
    double squared = 0;
    for (std::size_t j = 0; j < dimension; ++j)
      squared += std::pow(positions[i + j] - positions[j] - along * axis_of_tow[j], 2);
    errors.push_back(std::sqrt(squared));
  }
  return errors;
}

TowMeasures TowReport::measure(const State& state, const std::vector<double>& reactions) const {
  TowMeasures result;
  const std::vector<double> x = line_->positions(state);
  const std::vector<double> axis_of_tow = axis(state.time);
  const std::vector<double> errors = positioning_errors(x, state.time);
  const std::size_t dimension = axis_of_tow.size();
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
  result.force = split_force(force, axis_of_tow);
  return result;
}

double TowReport::exact_end_error(double length, double time) const {
  // Relative to the water the cable moves with V along the axis and U against the current.
  const auto along = axis(time);
  const double speed = track_ ? track_->speed(time) : deck_.speed;
  const double x = speed * along[0], y = deck_.current + speed * along[1];
  const double relative = std::hypot(x, y);
  return relative > 0 ? length * std::abs(along[0] * y - along[1] * x) / relative : 0;
}

}  // namespace hawser
