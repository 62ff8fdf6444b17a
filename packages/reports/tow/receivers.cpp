#include "receivers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "navigation_file.hpp"

namespace hawser {
namespace {

std::vector<Column> columns_in(const Mesh& mesh) {
  std::vector<Column> columns = {
      {"t", "s"}, {"receiver", ""}, {"arc_length", "m"}, {"x", "m"}, {"y", "m"}};
  if (mesh.dimension == 3) columns.push_back({"z", "m"});
  for (const Column& column :
       {Column{"offset", "m"}, {"feather_angle", "deg"}, {"tension", mesh.force_unit()}})
    columns.push_back(column);
  return columns;
}

}  // namespace

Receivers::Receivers(const Assembler& assembler, const LineGeometry& line,
                     const ReceiversDeck& deck,
                     std::function<std::vector<double>(const State&)> axis,
                     Diagnostics& diagnostics)
    : assembler_(assembler), line_(line), deck_(deck), axis_(std::move(axis)) {
  std::sort(deck_.times.value.begin(), deck_.times.value.end());
  const double end = line.arc_length().back() * (1 + 1e-12);
  places_ = deck_.at.value;
  for (int i = 0; deck_.at->empty() && deck_.first + i * deck_.spacing <= end; ++i)
    places_.push_back(deck_.first + i * deck_.spacing);
  if (!places_.empty() && places_.back() > end)
    diagnostics.error(
        deck.at.location,
        fmt::format("a receiver at {:g} m is beyond the end of the cable '{}', which is "
                    "{:g} m long",
                    places_.back(), line.region().name, line.arc_length().back()));
  if (places_.empty())
    diagnostics.error(deck.first.location,
                      fmt::format("the first receiver, at {:g} m, is beyond the end of the cable "
                                  "'{}', which is {:g} m long",
                                  deck.first.value, line.region().name, line.arc_length().back()));
}

void Receivers::look_ahead(const RunSpan& span, Diagnostics& diagnostics) const {
  if (deck_.every > 0 && deck_.times->empty() && !span.steady &&
      deck_.every * span.first_step > 1.001 * (span.end - span.begin))
    diagnostics.note(deck_.first.location,
                     fmt::format("the receivers are asked for every {} steps, and in steps of {:g} "
                                 "s the run ends before: nothing will be written of them",
                                 deck_.every, span.first_step));
  std::vector<std::string> beyond;
  for (const double time : deck_.times.value)
    if (time > span.end + 1e-9 * std::abs(span.end)) beyond.push_back(fmt::format("{:g}", time));
  if (beyond.empty()) return;
  const std::string text =
      fmt::format("the receivers are asked for at t = {} s, and the run ends at {:g} s",
                  hawser::listed(beyond), span.end);
  if (span.shortened)
    diagnostics.note(deck_.times.location, text + ", which is not the deck's end");
  else
    diagnostics.error(deck_.times.location, text);
}

void Receivers::open(const std::string& file, const ReportStart& start) {
  const Mesh& mesh = assembler_.dofs().mesh();
  file_ = std::make_unique<History>(mesh.communicator, start.folder + "/" + file, columns_in(mesh),
                                    start.keep_until());
  folder_ = start.folder;
  name_ = file;
  const double way = before_.way;
  before_ = sample(start.state);
  before_.way = way;
  // The beginning is no step's end; a run that goes on has written it already.
  if (!start.goes_on && deck_.shot_distance > 0) file_->append(before_.rows);
  for (const double time : deck_.times.value)
    if (!start.goes_on && time == before_.time) file_->append(before_.rows);
}

void Receivers::stepped(const Step& step) {
  Sample now = sample(step.end);
  const double slack = 1e-9 * (now.time - before_.time);
  for (const double time : deck_.times.value) {
    if (time <= before_.time + slack || time > now.time + slack) continue;
    append_between(now, std::min(1.0, (time - before_.time) / (now.time - before_.time)), time);
  }
  now.way = before_.way + std::hypot(now.head[0] - before_.head[0], now.head[1] - before_.head[1]);
  if (deck_.shot_distance > 0) append_shots(now);
  const bool at_the_end =
      step.last && deck_.times->empty() && deck_.every == 0 && deck_.shot_distance == 0;
  const bool asked_already =
      std::any_of(deck_.times->begin(), deck_.times->end(),
                  [&](double time) { return std::abs(time - now.time) <= slack; });
  if (at_the_end || (deck_.every > 0 && step.number % deck_.every == 0 && !asked_already))
    file_->append(now.rows);
  before_ = std::move(now);
  if (step.last && deck_.navigation)
    write_navigation(assembler_.dofs().mesh(), folder_ + "/" + name_, folder_, *deck_.navigation);
}

void Receivers::append_between(const Sample& now, double share, double time) {
  std::vector<double> rows = now.rows;
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = (1 - share) * before_.rows[i] + share * now.rows[i];
  for (std::size_t i = 0; i < rows.size(); i += now.rows.size() / places_.size())
    rows[i] = time;
  file_->append(rows);
}

void Receivers::append_shots(const Sample& now) {
  const double distance = deck_.shot_distance;
  const double slack = 1e-9 * distance;
  for (double n = std::floor((before_.way + slack) / distance) + 1; n * distance <= now.way + slack;
       ++n) {
    const double share = std::min(1.0, (n * distance - before_.way) / (now.way - before_.way));
    append_between(now, share, before_.time + share * (now.time - before_.time));
  }
}

Receivers::Sample Receivers::sample(const State& state) const {
  const std::vector<double>& arc = line_.arc_length();
  const std::vector<double> x = line_.positions(state);
  std::vector<double> tension(arc.size() - 1, 0);
  for (const auto& quantity : assembler_.cell_quantities(line_.region(), state))
    if (quantity.name == "tension") tension = line_.gather_cells(quantity.values);
  const auto node_tension = [&](std::size_t i) {
    return 0.5 * (tension[i == 0 ? 0 : i - 1] + tension[std::min(i, tension.size() - 1)]);
  };
  const auto axis = axis_(state);
  const auto astern = [&](const double* from) { return -(from[0] * axis[0] + from[1] * axis[1]); };
  const auto starboard = [&](const double* from) { return from[0] * axis[1] - from[1] * axis[0]; };

  Sample result;
  result.time = state.time;
  result.head = {x[0], x[1]};
  const std::size_t dimension = axis.size();
  for (std::size_t r = 0; r < places_.size(); ++r) {
    const auto above = std::upper_bound(arc.begin() + 1, arc.end() - 1, places_[r]);
    const auto i = static_cast<std::size_t>(above - arc.begin());
    const double share = std::min(1.0, (places_[r] - arc[i - 1]) / (arc[i] - arc[i - 1]));
    const auto between = [&](double a, double b) { return (1 - share) * a + share * b; };
    result.rows.insert(result.rows.end(), {state.time, static_cast<double>(r + 1), places_[r]});
    double here[3] = {0, 0, 0};   // from the tow point
    double chord[3] = {0, 0, 0};  // the same, or the first segment
    for (std::size_t j = 0; j < dimension; ++j) {
      const double position = between(x[dimension * (i - 1) + j], x[dimension * i + j]);
      result.rows.push_back(position);
      here[j] = position - x[j];
      chord[j] = places_[r] == 0 ? x[dimension + j] - x[j] : here[j];
    }
    result.rows.insert(result.rows.end(),
                       {starboard(here), std::atan2(starboard(chord), astern(chord)) / degree,
                        between(node_tension(i - 1), node_tension(i))});
  }
  return result;
}

}  // namespace hawser
