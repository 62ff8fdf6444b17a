// What tables say is compared with what the run will ask of them, before its first step.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hawser/base/error.hpp"
#include "hawser/conditions/conditions.hpp"
#include "hawser/deck/value.hpp"

namespace hawser {
namespace {

// A jump is told that is more than this, or more than this share of the way in the first step.
constexpr double least_jump = 1e-3;  // m
constexpr double least_share = 0.1;

std::string span_text(const Span& span, const std::string& variable = "t",
                      const std::string& unit = "s") {
  const auto value = [&](double at) { return variable + " = " + write_value(at) + " " + unit; };
  return "from " + value(span.from) + " to " + value(span.until);
}

double length(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

}  // namespace

Span Conditions::needed_times(const Entry& entry, const State& start, double first_step,
                              double end) {
  const double first = std::isfinite(start.step) ? start.time : start.time + first_step;
  return {std::max(first, entry.from), std::min(end, entry.until)};
}

Conditions::Moves Conditions::moves(const Entry& entry, const State& start, double first,
                                    double next) const {
  const auto components = static_cast<std::size_t>(entry.source->components());
  std::vector<double> now(components), then(components), later(components);
  Moves result;
  for (const LocalIndex row : entry.first_rows) {
    SpaceTime at = point(row, start);
    for (std::size_t c = 0; c < components; ++c)
      now[c] = start.value[static_cast<std::size_t>(row + entry.first_component) + c];
    at.t = first;
    entry.source->value(at, then.data());
    at.t = next;
    entry.source->value(at, later.data());
    result.jump = std::max(result.jump, length(now, then));
    result.way = std::max(result.way, length(then, later));
  }
  return result;
}

std::array<Span, 3> Conditions::needed_places(const Entry& entry, const State& start) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<Span, 3> places;
  places.fill({infinity, -infinity});
  for (const LocalIndex row : entry.first_rows) {
    const SpaceTime at = point(row, start);
    const double position[] = {at.x, at.y, at.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      places[axis].from = std::min(places[axis].from, position[axis]);
      places[axis].until = std::max(places[axis].until, position[axis]);
    }
  }
  const Communicator& communicator = dofs_.mesh().communicator;
  for (Span& along : places)
    along = {-communicator.max(-along.from), communicator.max(along.until)};
  return places;
}

void Conditions::check_source(const Entry& entry, const State& start, double first_step, double end,
                              bool jump_is_meant) const {
  const Span needed = needed_times(entry, start, first_step, end);
  if (needed.from > needed.until) return;
  const auto fault = [&](const std::string& sentence) {
    throw DeckError(entry.place.text() + ": " + sentence);
  };
  if (const Span span = entry.source->span(); !span.covers(needed.from, needed.until))
    fault("the table reaches " + span_text(span) + ", and the run needs it " + span_text(needed) +
          "; a longer table would do, another time-origin of <table>, another end of <time>, or a "
          "window (from, until) of the condition");
  const std::array<Span, 3> places = needed_places(entry, start);
  for (int axis = 0; axis < 3; ++axis) {
    const Span span = entry.source->reach(axis);
    const Span& along = places[static_cast<std::size_t>(axis)];
    const std::string name(1, "xyz"[axis]);
    if (along.from <= along.until && !span.covers(along.from, along.until))
      fault("the table reaches " + span_text(span, name, "m") +
            ", and the nodes of this condition " + span_text(along, name, "m"));
  }
  const Communicator& communicator = dofs_.mesh().communicator;
  long long points = 0;
  for (const LocalIndex row : entry.first_rows)
    points += row < dofs_.owned() ? 1 : 0;
  points = communicator.sum(points);
  if (entry.source->places_a_point() && points > 1)
    fault("a table of positions is for one point, and there are " + std::to_string(points) +
          " nodes here, which would all be brought there; relative=\"true\" of <table> moves them "
          "alike");
  Moves found;
  communicator.together([&] {
    at_its_place(entry, [&] {
      found = moves(entry, start, needed.from, std::min(needed.from + first_step, needed.until));
    });
  });
  found = {communicator.max(found.jump), communicator.max(found.way)};
  const bool holds_at_once = needed.from <= start.time;
  if (!entry.is_displacement || jump_is_meant || !holds_at_once) return;
  if (found.jump > std::max(least_share * found.way, least_jump))
    fault("at t = " + write_value(needed.from) + " s the table is " +
          write_value(std::round(found.jump * 1000) / 1000) +
          " m away from where the point is, which the first step would bring there; let the table "
          "begin there, give an <initial> displacement or the right origin of <table>, or let it "
          "count from its own start: relative=\"true\"");
}

void Conditions::check_sources(const State& start, double first_step, double end,
                               bool jump_is_meant) const {
  for (const Entry& entry : prescribed_)
    if (entry.is_table) check_source(entry, start, first_step, end, jump_is_meant);
}

}  // namespace hawser
