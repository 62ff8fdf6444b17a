#include "tow_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/fields/look_up.hpp"
#include "hawser/physics/field_use.hpp"
#include "tow.hpp"

namespace hawser {

void register_tow(ReportRegistry& registry) { registry.add<TowReport>(); }

TowMeasures measure_tow(const std::vector<double>& positions, const std::vector<double>& errors,
                        std::size_t dimension) {
  TowMeasures result;
  const std::vector<double>& x = positions;
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
  return result;
}

std::vector<double> distances_from_axis(const std::vector<double>& positions,
                                        const std::vector<double>& axis) {
  std::vector<double> errors;
  const std::size_t dimension = axis.size();
  for (std::size_t i = 0; i < positions.size(); i += dimension) {
    double along = 0;
    for (std::size_t j = 0; j < dimension; ++j)
      along += (positions[i + j] - positions[j]) * axis[j];
    double squared = 0;
    for (std::size_t j = 0; j < dimension; ++j)
      squared += std::pow(positions[i + j] - positions[j] - along * axis[j], 2);
    errors.push_back(std::sqrt(squared));
  }
  return errors;
}

TowReport::TowReport(const TowDeck& deck, const ReportContext& context, Diagnostics& diagnostics)
    : dofs_(context.dofs()), deck_(deck) {
  if (deck.track) track_ = find_track(context.tracks, *deck.track, diagnostics);
  const Mesh& mesh = context.mesh();
  const Region* const cable =
      find_region_of({CellShape::line}, mesh, deck.cable, "<tow>", diagnostics);
  const Region* const tow_point = find_point(mesh, deck.tow_point, "<tow>", diagnostics);
  find_field(dofs_, {field_name::velocity, deck.cable.location}, diagnostics);
  if (cable == nullptr || tow_point == nullptr) return;
  for (const LocalIndex vertex : tow_point->vertices)
    if (vertex < mesh.vertices.owned) tow_point_ = vertex;
  try {
    line_ = std::make_unique<LineGeometry>(dofs_, *cable, *tow_point);
  } catch (const MeshError& error) {
    diagnostics.error(deck.cable.location, error.what());
    return;
  }
  if (deck.receivers)
    receivers_ = std::make_unique<Receivers>(
        context.assembler, *line_, *deck.receivers,
        [this](const State& state) { return axis(state); }, diagnostics);
}

std::vector<double> TowReport::axis_as_said(double time) const {
  std::vector<double> result(static_cast<std::size_t>(dofs_.mesh().dimension), 0);
  result[0] = std::sin(deck_.angle * degree);
  result[1] = std::cos(deck_.angle * degree);
  if (track_) {
    const auto course = track_->course(time);
    std::copy(course.begin(), course.end(), result.begin());
  }
  return result;
}

std::array<double, 2> TowReport::motion(const State& state) const {
  std::array<double, 2> mine = {0, 0}, all = {0, 0};
  if (tow_point_ >= 0)
    for (std::size_t j = 0; j < 2; ++j)
      mine[j] = state.value[static_cast<std::size_t>(dofs_.first_row(
                                dofs_.find(field_name::velocity), PointKind::vertex, tow_point_)) +
                            j];
  MPI_Allreduce(mine.data(), all.data(), 2, MPI_DOUBLE, MPI_SUM, dofs_.mesh().communicator.mpi());
  return all;
}

std::vector<double> TowReport::axis(const State& state) const {
  if (!follows_motion()) return axis_as_said(state.time);
  std::vector<double> result(static_cast<std::size_t>(dofs_.mesh().dimension), 0);
  const auto velocity = motion(state);
  const double speed = std::hypot(velocity[0], velocity[1]);
  if (speed > 0) {
    result[0] = velocity[0] / speed;
    result[1] = velocity[1] / speed;
    return result;
  }
  // It rests: straight on from the tail to the tow point.
  const std::vector<double> x = line_->positions(state);
  const std::size_t tail = x.size() - result.size();
  const double length = std::hypot(x[0] - x[tail], x[1] - x[tail + 1]);
  result[1] = length > 0 ? (x[1] - x[tail + 1]) / length : 1;
  result[0] = length > 0 ? (x[0] - x[tail]) / length : 0;
  return result;
}

double TowReport::exact_end_error(double length, const State& state) const {
  // Relative to the water the cable moves with V along the axis and U against the current.
  const auto along = axis(state);
  const auto velocity = motion(state);
  const double speed = follows_motion() ? std::hypot(velocity[0], velocity[1])
                       : track_         ? track_->speed(state.time)
                                        : *deck_.speed;
  const double x = speed * along[0], y = *deck_.current + speed * along[1];
  const double relative = std::hypot(x, y);
  return relative > 0 ? length * std::abs(along[0] * y - along[1] * x) / relative : 0;
}

std::vector<Column> TowReport::columns() const {
  std::vector<Column> result = {{deck_.named("end_error"), "m"},
                                {deck_.named("total_error"), "m"},
                                {deck_.named("total_error_arc"), "m"}};
  for (const Column& force : force_columns(deck_.named("tow"), dofs_.mesh()))
    result.push_back(force);
  result.push_back({deck_.named("cable_angle"), "deg"});
  result.push_back({deck_.named("cable_length"), "m"});
  return result;
}

std::vector<std::string> TowReport::quantities() const {
  std::vector<std::string> names = Report::quantities();
  if (has_exact())
    for (const char* name : {"end_error_exact_m", "total_error_exact_m"})
      names.push_back(deck_.named(name));
  names.push_back(deck_.named("end_error_change_last_quarter_m"));
  return names;
}

std::vector<double> TowReport::measure(const Step& step) {
  const double time = step.end.time;
  const std::vector<double> x = line_->positions(step.end), axis_of_tow = axis(step.end);
  last_ = measure_tow(x, distances_from_axis(x, axis_of_tow), axis_of_tow.size());
  if (has_exact()) exact_ = exact_end_error(last_.length, step.end);
  end_errors_.emplace_back(time, last_.end_error);
  const Force force = tow_force(step.reactions, axis_of_tow);
  return {last_.end_error, last_.total_error, last_.total_error_arc, force.magnitude,
          force.along,     force.across,      last_.cable_angle,     last_.length};
}

Force TowReport::tow_force(const std::vector<double>& reactions,
                           const std::vector<double>& axis) const {
  std::vector<double> force(axis.size(), 0);
  const int velocity = dofs_.find(field_name::velocity);
  for (const auto& node : line_->owned())
    if (node.place == 0)
      for (std::size_t j = 0; j < force.size(); ++j)
        force[j] = reactions[static_cast<std::size_t>(
                                 dofs_.first_row(velocity, PointKind::vertex, node.vertex)) +
                             j];
  MPI_Allreduce(MPI_IN_PLACE, force.data(), static_cast<int>(force.size()), MPI_DOUBLE, MPI_SUM,
                dofs_.mesh().communicator.mpi());
  return split_force(force, axis);
}

void TowReport::start(const ReportStart& start) {
  std::vector<Column> columns = {{"t", "s"}, {"arc_length", "m"}, {"x", "m"}, {"y", "m"}};
  if (dofs_.mesh().dimension == 3) columns.push_back({"z", "m"});
  columns.push_back({"positioning_error", "m"});
  nodes_ = std::make_unique<History>(dofs_.mesh().communicator,
                                     start.folder + "/" + deck_.named("cable.csv"), columns,
                                     start.keep_until());
  if (receivers_) receivers_->open(deck_.named("receivers.csv"), start);
}

void TowReport::write(const Step& step, bool fields_due) {
  if (fields_due) {
    const std::vector<double> x = line_->positions(step.end), axis_of_tow = axis(step.end);
    const std::vector<double> errors = distances_from_axis(x, axis_of_tow);
    const std::size_t dimension = axis_of_tow.size();
    std::vector<double> rows;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      rows.insert(rows.end(), {step.end.time, line_->arc_length()[i]});
      for (std::size_t j = 0; j < dimension; ++j)
        rows.push_back(x[dimension * i + j]);
      rows.push_back(errors[i]);
    }
    nodes_->append(rows);
  }
  if (receivers_) receivers_->stepped(step);
}

void TowReport::add_fields(const Region& line, const State& state,
                           std::vector<PointField>& fields) const {
  if (&line != &line_->region()) return;
  const auto errors = distances_from_axis(line_->positions(state), axis(state));
  PointField& field = fields.emplace_back(PointField{deck_.named("positioning_error"), "m", 1, {}});
  for (const auto& node : line_->owned())
    field.values.push_back(errors[node.place]);
}

void TowReport::save(CheckpointNotes& notes) const {
  std::string& text = notes.texts["end_errors"];
  for (const auto& [time, error] : end_errors_)
    text += write_value(time) + " " + write_value(error) + "\n";
  if (receivers_) notes.numbers["way"] = receivers_->way();
}

void TowReport::resume(const CheckpointNotes& notes) {
  std::istringstream text(notes.texts.at("end_errors"));
  for (double time = 0, error = 0; text >> time >> error;)
    end_errors_.emplace_back(time, error);
  if (const auto way = notes.numbers.find("way"); receivers_ && way != notes.numbers.end())
    receivers_->resume(way->second);
}

void TowReport::summarise(const Step& last, Summary& summary) const {
  Report::summarise(last, summary);
  double least = last_.end_error, greatest = last_.end_error;
  for (const auto& [time, error] : end_errors_)
    if (time >= 0.75 * last.end.time) {
      least = std::min(least, error);
      greatest = std::max(greatest, error);
    }
  if (exact_) {
    summary.set(deck_.named("end_error_exact_m"), *exact_);
    summary.set(deck_.named("total_error_exact_m"), *exact_ / 2);
  }
  summary.set(deck_.named("end_error_change_last_quarter_m"), greatest - least);
}

std::string TowReport::closing() const {
  const std::string unit = dofs_.mesh().force_unit();
  const auto metres = [](std::optional<double> value) {
    return value ? fmt::format("{:.2f} m", *value) : std::string("-");
  };
  const auto half = exact_ ? std::optional(*exact_ / 2) : std::nullopt;
  return fmt::format(
      "\n{:<28}{:>14}{:>22}\n"
      "{:<28}{:>12.2f} m{:>22}\n"
      "{:<28}{:>12.2f} m{:>22}\n"
      "{:<28}{:>{}.0f} {}{:>22}\n",
      deck_.name, "this run", "exact straight cable", "end error", last_.end_error, metres(exact_),
      "total error (along cable)", last_.total_error_arc, metres(half),
      unit == "N" ? "tow force" : "tow force, per m of depth", values()[3], 13 - unit.size(), unit,
      "-");
}

}  // namespace hawser
