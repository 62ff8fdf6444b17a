#include "hawser/values/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/spec_reader.hpp"
#include "hawser/deck/value.hpp"

namespace hawser {
namespace {

constexpr const char* variable_names[] = {"t", "x", "y"};
constexpr const char* variable_units[] = {"_s", "_m", "_m"};

/// A CSV file's lines with their numbers; blank lines and lines that begin with # are skipped.
struct Line {
  int number = 0;
  std::vector<std::string> cells;
};
std::vector<Line> lines_of(const std::string& text) {
  std::vector<Line> lines;
  std::istringstream stream(text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const std::string content = trimmed(line);
    if (!content.empty() && content[0] != '#') lines.push_back({number, split_at(content, ',')});
  }
  return lines;
}

double number_in(const std::string& cell, const std::string& where) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0' || !std::isfinite(value))
    throw DeckError(where + quoted(cell) + " is no number");
  return value;
}

}  // namespace

Table::Table(const std::string& text, const std::string& file) : file_(file) {
  const std::vector<Line> lines = lines_of(text);
  const auto at = [&](int line) { return file + ":" + std::to_string(line) + ": "; };
  if (lines.size() < 2)
    throw DeckError(file + ": a table needs a line with the columns' names and at least one row");

  std::vector<int> meaning;  // per column: a variable, or `variables` for a component
  for (const std::string& name : lines.front().cells) {
    int found = variables;
    for (int v = 0; v < variables; ++v)
      if (name == variable_names[v] || name == std::string(variable_names[v]) + variable_units[v])
        found = v;
    if (found != variables && std::count(meaning.begin(), meaning.end(), found) > 0)
      throw DeckError(at(lines.front().number) + "the column " + quoted(name) + " is given twice");
    meaning.push_back(found);
    if (found == variables) ++components_;
  }
  const std::string rule = "; allowed: t, x, y and after them a column per component";
  if (components_ == 0)
    throw DeckError(at(lines.front().number) + "no column holds a component" + rule);
  if (components_ == static_cast<int>(meaning.size()))
    throw DeckError(at(lines.front().number) + "there is no column t, x or y, but " +
                    listed(lines.front().cells) + rule);

  std::vector<std::array<double, variables>> points;
  std::vector<double> given;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const Line& line = lines[i];
    if (line.cells.size() != meaning.size())
      throw DeckError(at(line.number) + std::to_string(line.cells.size()) + " values, but " +
                      std::to_string(meaning.size()) + " columns");
    std::array<double, variables> point{};
    for (std::size_t c = 0; c < meaning.size(); ++c) {
      const double value = number_in(line.cells[c], at(line.number));
      if (meaning[c] == variables)
        given.push_back(value);
      else
        point[static_cast<std::size_t>(meaning[c])] = value;
    }
    points.push_back(point);
  }

  std::size_t rows = 1;
  for (std::size_t v = variables; v-- > 0;) {
    if (std::count(meaning.begin(), meaning.end(), static_cast<int>(v)) == 0) continue;
    std::vector<double>& knots = axes_[v].knots;
    for (const auto& point : points)
      knots.push_back(point[v]);
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    axes_[v].stride = rows;
    rows *= knots.size();
  }
  std::vector<int> line_of(rows, 0);
  values_.assign(rows * static_cast<std::size_t>(components_), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t row = 0;
    for (std::size_t v = 0; v < variables; ++v) {
      const auto& knots = axes_[v].knots;
      if (knots.empty()) continue;
      row += axes_[v].stride *
             static_cast<std::size_t>(std::lower_bound(knots.begin(), knots.end(), points[i][v]) -
                                      knots.begin());
    }
    if (line_of[row] != 0)
      throw DeckError(at(lines[i + 1].number) + "time and place are those of line " +
                      std::to_string(line_of[row]));
    line_of[row] = lines[i + 1].number;
    std::copy_n(given.begin() + static_cast<std::ptrdiff_t>(i) * components_, components_,
                values_.begin() + static_cast<std::ptrdiff_t>(row) * components_);
  }
  const auto gap = std::find(line_of.begin(), line_of.end(), 0);
  if (gap == line_of.end()) return;
  const auto row = static_cast<std::size_t>(gap - line_of.begin());
  std::string where;
  for (std::size_t v = 0; v < variables; ++v) {
    const auto& knots = axes_[v].knots;
    if (!knots.empty())
      where += std::string(where.empty() ? "" : ", ") + variable_names[v] + " = " +
               write_value(knots[row / axes_[v].stride % knots.size()]);
  }
  throw DeckError(file + ": the rows do not fill a grid: none for " + where + ", and " +
                  std::to_string(std::count(line_of.begin(), line_of.end(), 0)) +
                  " missing in all");
}

Table::Places Table::locate(const SpaceTime& at) const {
  const double wanted[] = {at.t, at.x, at.y};
  Places places;
  for (std::size_t v = 0; v < variables; ++v) {
    const std::vector<double>& knots = axes_[v].knots;
    if (knots.empty()) continue;
    // Times are sums of steps: what lies outside by their rounding only counts as inside.
    const double slack = 1e-9 * (std::abs(knots.front()) + std::abs(knots.back()));
    if (wanted[v] < knots.front() - slack || wanted[v] > knots.back() + slack)
      throw DeckError(file_ + ": no value at " + variable_names[v] + " = " +
                      write_value(wanted[v]) + " " + (variable_units[v] + 1) +
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
  for (int c = 0; c < components_; ++c)
    values[c] = interpolate(places, c, -1);
}

void Table::time_derivative(const SpaceTime& at, double* rates) const {
  const Places places = locate(at);
  for (int c = 0; c < components_; ++c)
    rates[c] = interpolate(places, c, t);
}

void Table::gradient(const SpaceTime& at, int component, double* slope) const {
  const Places places = locate(at);
  slope[0] = interpolate(places, component, x);
  slope[1] = interpolate(places, component, y);
  slope[2] = 0;
}

bool Table::depends_on_moved_position(int) const {
  return axes_[x].knots.size() > 1 || axes_[y].knots.size() > 1;
}

}  // namespace hawser
