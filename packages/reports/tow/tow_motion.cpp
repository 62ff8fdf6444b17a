// Does the tow point move as <tow> says?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tow_report.hpp"

namespace hawser {
namespace {

constexpr int instants = 64;
constexpr double slack = degree;  // between the axis and the motion

double length(const double* v, std::size_t dimension) {
  double squared = 0;
  for (std::size_t j = 0; j < dimension; ++j)
    squared += v[j] * v[j];
  return std::sqrt(squared);
}

double angle_between(const double* v, const std::vector<double>& axis) {
  double along = 0;
  for (std::size_t j = 0; j < axis.size(); ++j)
    along += v[j] * axis[j];
  return std::acos(std::clamp(along / length(v, axis.size()), -1.0, 1.0));
}

/// As the attribute 'angle' has it.
double tow_angle(const double* v) { return std::atan2(v[0], v[1]) / degree; }

}  // namespace

void TowReport::look_ahead(const Outlook& outlook, Diagnostics& diagnostics) const {
  if (receivers_) receivers_->look_ahead(outlook.span, diagnostics);
  if (!has_exact())
    diagnostics.note(
        deck_.cable.location,
        "there is no exact value to compare the errors with: <tow> does not say " +
            std::string(deck_.current                               ? "speed"
                        : track_ || deck_.speed || follows_motion() ? "current"
                                                                    : "speed and current"));
  if (!outlook.span.steady && !follows_motion()) compare_motion(outlook, diagnostics);
}

void TowReport::compare_motion(const Outlook& outlook, Diagnostics& diagnostics) const {
  const auto dimension = static_cast<std::size_t>(dofs_.mesh().dimension);
  const RunSpan& span = outlook.span;
  const auto time = [&](int i) { return span.begin + (span.end - span.begin) * i / instants; };
  // Per instant; from the rank that owns the tow point.
  std::vector<double> motion(dimension * (instants + 1), 0);
  for (int i = 1; tow_point_ >= 0 && i <= instants; ++i)
    if (const auto known =
            outlook.conditions.prescribed_velocity(tow_point_, time(i), outlook.state))
      std::copy(known->begin(), known->end(), &motion[dimension * static_cast<std::size_t>(i)]);
  MPI_Allreduce(MPI_IN_PLACE, motion.data(), static_cast<int>(motion.size()), MPI_DOUBLE, MPI_SUM,
                dofs_.mesh().communicator.mpi());
  const auto velocity = [&](int i) { return &motion[dimension * static_cast<std::size_t>(i)]; };
  int fastest = 0;
  for (int i = 1; i <= instants; ++i)
    if (length(velocity(i), dimension) > length(velocity(fastest), dimension)) fastest = i;
  const double speed = length(velocity(fastest), dimension);
  if (!(speed > 0)) return;  // held, free, or in a frame that moves with it
  double least = pi, most = 0;
  int astray = fastest;
  for (int i = 1; i <= instants; ++i) {
    if (length(velocity(i), dimension) < 0.1 * speed) continue;  // a start or an end
    const double off = angle_between(velocity(i), axis_as_said(time(i)));
    least = std::min(least, off);
    if (off > most) astray = i;
    most = std::max(most, off);
  }
  const std::string axis_text =
      track_ ? "the course of the track '" + deck_.track->value + "'"
             : fmt::format("the axis of <tow>, angle=\"{:g}\"", deck_.angle.value);
  const Location& where =
      track_ ? deck_.track->location
             : (deck_.angle.location.line > 0 ? deck_.angle.location : deck_.cable.location);
  if (least > slack) {
    diagnostics.error(
        where,
        fmt::format("the tow point never moves along {}: at t = {:g} s it goes "
                    "in the direction of angle=\"{:.6g}\"; with course=\"motion\" the axis is "
                    "where it goes",
                    axis_text, time(fastest), tow_angle(velocity(fastest))));
    return;
  }
  if (most > slack) {
    diagnostics.note(
        where, fmt::format("the tow point does not always move along {}: at t = {:g} s "
                           "it goes in the direction of angle=\"{:.6g}\"; errors are "
                           "measured from that axis; with course=\"motion\" it is where the tow "
                           "point goes",
                           axis_text, time(astray), tow_angle(velocity(astray))));
    return;
  }
  if (!track_ && deck_.speed && std::abs(*deck_.speed - speed) > 0.01 * speed)
    diagnostics.note(where, fmt::format("the tow point reaches {:.4g} m/s, and <tow> says speed="
                                        "\"{:g}\", of which the exact values are",
                                        speed, *deck_.speed));
}

}  // namespace hawser
