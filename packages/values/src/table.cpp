#include "hawser/values/table.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/deck/value.hpp"
#include "src/table_reader.hpp"

namespace hawser {
namespace {

constexpr const char* variable_names[] = {"t", "x", "y", "z"};
constexpr const char* variable_units[] = {"s", "m", "m", "m"};

/// Times are sums of steps: what lies outside by their rounding only counts as inside.
double slack(const std::vector<double>& knots) {
  return 1e-9 * (std::abs(knots.front()) + std::abs(knots.back()));
}

}  // namespace

std::shared_ptr<const Table> Table::read(const std::string& text, const TableDeck& deck,
                                         const WantedValues& wanted, Diagnostics& diagnostics) {
  return TableReader(deck, wanted, diagnostics).read(text);
}

Table::Places Table::locate(const SpaceTime& at) const {
  const double wanted[] = {at.t, at.x, at.y, at.z};
  Places places;
  for (std::size_t v = 0; v < variables; ++v) {
    const std::vector<double>& knots = axes_[v].knots;
    if (knots.empty()) continue;
    if (wanted[v] < knots.front() - slack(knots) || wanted[v] > knots.back() + slack(knots))
      throw DeckError(file_ + ": no value at " + variable_names[v] + " = " +
                      write_value(wanted[v]) + " " + variable_units[v] +
                      "; the table reaches from " + write_value(knots.front()) + " to " +
                      write_value(knots.back()));
    if (knots.size() == 1) continue;
    const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, wanted[v]);
    Place& place = places[v];
    place.first = static_cast<std::size_t>(above - knots.begin()) - 1;
    place.width = *above - *(above - 1);
    place.share = std::clamp((wanted[v] - *(above - 1)) / place.width, 0.0, 1.0);
  }
  return places;
}

double Table::interpolate(const Places& places, int component, int slope_along) const {
  double sum = 0;
  for (unsigned corner = 0; corner < 1U << variables; ++corner) {
    double weight = 1;
    std::size_t row = 0;
    for (std::size_t v = 0; v < variables && weight != 0; ++v) {
      const Place& place = places[v];
      const bool high = (corner >> v & 1U) != 0;
      if (static_cast<int>(v) == slope_along)
        weight *= place.width > 0 ? (high ? 1 : -1) / place.width : 0;
      else
        weight *= high ? place.share : 1 - place.share;
      row += axes_[v].stride * (place.first + (high ? 1 : 0));
    }
    if (weight != 0)
      sum += weight * values_[row * static_cast<std::size_t>(components_) +
                              static_cast<std::size_t>(component)];
  }
  return sum;
}

void Table::value(const SpaceTime& at, double* values) const {
  const Places places = locate(at);
  const double first_place[] = {at.X, at.Y, at.Z};
  for (int c = 0; c < components_; ++c) {
    const auto i = static_cast<std::size_t>(c);
    values[c] = splines_.empty() ? interpolate(places, c, -1) : splines_[i].value(at.t);
    values[c] -= start_[i];
    if (places_a_point()) values[c] -= first_place[first_component_ + i];
  }
}

void Table::time_derivative(const SpaceTime& at, double* rates) const {
  const Places places = locate(at);
  for (int c = 0; c < components_; ++c)
    rates[c] = splines_.empty() ? interpolate(places, c, t)
                                : splines_[static_cast<std::size_t>(c)].rate(at.t);
}

void Table::gradient(const SpaceTime& at, int component, double* slope) const {
  const Places places = locate(at);
  for (const Variable v : {x, y, z})
    slope[v - x] = interpolate(places, component, v);
}

bool Table::depends_on_moved_position(int) const {
  return std::any_of(axes_.begin() + x, axes_.end(),
                     [](const Axis& axis) { return axis.knots.size() > 1; });
}

Span Table::span_of(int variable) const {
  const std::vector<double>& knots = axes_[static_cast<std::size_t>(variable)].knots;
  if (knots.empty()) return {};
  return {knots.front(), knots.back(), slack(knots)};
}

void Table::smooth(double period) {
  const auto components = static_cast<std::size_t>(components_);
  const std::vector<double>& times = axes_[t].knots;
  if (times.size() < 3) return;
  for (std::size_t c = 0; c < components; ++c) {
    std::vector<double> column(times.size());
    for (std::size_t i = 0; i < times.size(); ++i)
      column[i] = values_[i * components + c];
    splines_.emplace_back(times, column, period);
  }
}

void Table::count_from_start() {
  relative_ = true;
  SpaceTime start;
  start.t = std::clamp(0.0, axes_[t].knots.front(), axes_[t].knots.back());
  std::vector<double> first(static_cast<std::size_t>(components_));
  value(start, first.data());
  start_ = first;
}

}  // namespace hawser
