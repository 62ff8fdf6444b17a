#include "src/table_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "hawser/base/constants.hpp"
#include "hawser/deck/value.hpp"

namespace hawser {
namespace {

constexpr const char* names[] = {"t", "x", "y", "z"};

/// So many times the usual time between rows is a gap that the deck must allow.
constexpr double wide = 5;
constexpr std::size_t enough_to_tell = 4;  // times between rows

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string seconds(double time) { return write_value(time) + " s"; }

/// To two digits.
std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return write_value(std::strtod(text, nullptr));
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

}  // namespace

std::shared_ptr<const Table> TableReader::read(const std::string& text) {
  const std::size_t before = diagnostics_.error_count();
  const auto sound = [&] { return diagnostics_.error_count() == before; };
  csv_ = read_csv(text, deck_.file.value, diagnostics_);
  if (!sound()) return nullptr;
  const std::vector<TableColumn> columns = read_columns(csv_, deck_, wanted_, diagnostics_);
  if (!sound()) return nullptr;
  rows_ = read_rows(csv_, columns, deck_, wanted_, diagnostics_);
  if (sound() && rows_.rows.empty())
    diagnostics_.error({csv_.file, csv_.header.number, 1}, "in every row a value is missing");
  if (!sound()) return nullptr;
  check_options();
  check_order();
  if (!sound()) return nullptr;
  check_gaps();
  check_roughness();
  const std::shared_ptr<Table> table(new Table());
  fill_grid(*table);
  if (!sound()) return nullptr;
  if (deck_.smooth && deck_.smooth->value > 0) table->smooth(deck_.smooth->value);
  if (deck_.relative) table->count_from_start();
  return table;
}

bool TableReader::over_time_alone() const {
  return rows_.has == std::array<bool, 4>{true, false, false, false};
}

void TableReader::check_options() {
  if (deck_.relative && !(wanted_.is_place && over_time_alone()))
    diagnostics_.error(deck_.name.location,
                       "relative is for displacements over time, and the table is asked for '" +
                           wanted_.field + "'");
  if (!deck_.smooth || deck_.smooth->value == 0) return;
  if (!over_time_alone())
    diagnostics_.error(deck_.smooth->location,
                       "smooth is for tables over time alone, and " + csv_.file + " has places");
  else if (const double spacing = rows_.rows.size() > 1
                                      ? (rows_.rows.back().point[0] - rows_.rows[0].point[0]) /
                                            static_cast<double>(rows_.rows.size() - 1)
                                      : 0;
           spacing > 0 && deck_.smooth->value > 2000 * spacing)
    diagnostics_.error(deck_.smooth->location, "smooth is " + seconds(deck_.smooth->value) +
                                                   ", more than 2000 rows of " + csv_.file +
                                                   ": round-off would show; take every tenth row");
}

void TableReader::check_order() {
  if (!over_time_alone()) return;
  int told = 0;
  for (std::size_t i = 1; i < rows_.rows.size() && told < most_told; ++i) {
    const TableRow &last = rows_.rows[i - 1], &row = rows_.rows[i];
    if (row.point[0] > last.point[0]) continue;
    ++told;
    diagnostics_.error(place(row),
                       row.point[0] == last.point[0]
                           ? "its time is that of line " + std::to_string(last.line->number) +
                                 "; take one of the two away"
                           : "the time goes back from " + seconds(last.point[0]) + " to " +
                                 seconds(row.point[0]) + "; rows are needed in the order of time");
  }
}

void TableReader::check_gaps() {
  if (!over_time_alone() || rows_.rows.size() < 2) return;
  std::vector<double> lengths;
  for (std::size_t i = 1; i < rows_.rows.size(); ++i)
    lengths.push_back(rows_.rows[i].point[0] - rows_.rows[i - 1].point[0]);
  const double usual = median(lengths);
  int told = 0;
  for (std::size_t i = 0; i < lengths.size() && told < most_told; ++i) {
    const TableRow &before = rows_.rows[i], &after = rows_.rows[i + 1];
    const auto& out = rows_.without_value;
    const auto left_out =
        std::upper_bound(out.begin(), out.end(), before.line->number,
                         [](int number, const CsvLine* line) { return number < line->number; });
    const bool missing = left_out != out.end() && (*left_out)->number < after.line->number;
    if (deck_.longest_gap) {
      // To round-off, for times are sums and quotients.
      if (lengths[i] <= *deck_.longest_gap * (1 + 1e-9)) continue;
    } else if (!missing && (lengths.size() < enough_to_tell || lengths[i] < wide * usual)) {
      continue;
    }
    ++told;
    const Location where = missing ? Location{csv_.file, (*left_out)->number, 1} : place(after);
    diagnostics_.error(
        where,
        "there is no value between t = " + seconds(before.point[0]) + " and " +
            seconds(after.point[0]) +
            (deck_.longest_gap
                 ? ", longer than longest-gap=\"" + seconds(*deck_.longest_gap) + "\""
                 : std::string(missing ? ""
                                       : ", where rows mostly are " + seconds(usual) + " apart") +
                       "; longest-gap=\"" + seconds(lengths[i]) +
                       "\" of <table> lets a straight line bridge it"));
  }
}

/// A track that changes its velocity by half of it from row to row is noise at its rows' distance.
void TableReader::check_roughness() {
  if (!wanted_.is_place || deck_.smooth || !over_time_alone() || rows_.rows.size() < 8) return;
  std::vector<double> speeds, changes;
  std::vector<double> last;
  for (std::size_t i = 1; i < rows_.rows.size(); ++i) {
    const TableRow &a = rows_.rows[i - 1], &b = rows_.rows[i];
    const double length = b.point[0] - a.point[0];
    std::vector<double> velocity(a.values.size());
    for (std::size_t c = 0; c < velocity.size(); ++c)
      velocity[c] = (b.values[c] - a.values[c]) / length;
    speeds.push_back(distance(velocity, std::vector<double>(velocity.size(), 0)));
    if (!last.empty()) changes.push_back(distance(velocity, last));
    last = velocity;
  }
  const double change = median(changes), speed = median(speeds);
  if (change <= 0.5 * speed || change == 0) return;
  // Noise of s per row leaves s sqrt(.0884 h w^3) in the velocity of a spline that halves the
  // frequency w; the period is that which leaves a fiftieth of the mean speed. The second
  // differences of the noise have the median 2.88 s in the plane.
  const double duration = rows_.rows.back().point[0] - rows_.rows.front().point[0];
  const double spacing = duration / static_cast<double>(rows_.rows.size() - 1);
  const double noise = change * spacing / 2.88;
  const double mean = distance(rows_.rows.back().values, rows_.rows.front().values) / duration;
  double period = 10 * spacing;
  if (mean > 0)
    period =
        std::max(period, 2 * pi * std::cbrt(0.0884 * spacing * std::pow(noise / (0.02 * mean), 2)));
  diagnostics_.error(
      place(rows_.rows.front()),
      "from row to row the velocity changes by " + rounded(change) + " m/s, and it is " +
          rounded(speed) + " m/s (medians): steps would feel the noise of the fixes; smooth=\"" +
          rounded(std::min(period, duration)) +
          " s\" of <table> smooths it, and smooth=\"0 s\" takes the rows as they are");
}

void TableReader::fill_grid(Table& table) {
  constexpr std::size_t variables = Table::variables;
  const std::size_t count = wanted_.count;
  table.file_ = csv_.file;
  table.components_ = static_cast<int>(count);
  table.is_position_ = rows_.is_position;
  table.first_component_ = wanted_.first;
  table.start_.assign(count, 0);
  auto& axes = table.axes_;
  double size = 1;
  std::size_t stride = 1;
  for (std::size_t v = variables; v-- > 0;) {
    if (!rows_.has[v]) continue;
    std::vector<double>& knots = axes[v].knots;
    for (const TableRow& row : rows_.rows)
      knots.push_back(row.point[v]);
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    axes[v].stride = stride;
    stride *= knots.size();
    size *= static_cast<double>(knots.size());
  }
  const Location header{csv_.file, csv_.header.number, 1};
  // Scattered places make as many knots of x and of y as there are rows: no grid, and no memory.
  if (size > 2.0 * static_cast<double>(rows_.rows.size()) + 1000) {
    diagnostics_.error(header, "the rows do not fill a grid: " + write_value(size) +
                                   " places and times, and " + std::to_string(rows_.rows.size()) +
                                   " rows with values; every time is needed with every place");
    return;
  }
  std::vector<const TableRow*> row_at(stride, nullptr);
  table.values_.assign(stride * count, 0);
  for (const TableRow& row : rows_.rows) {
    std::size_t at = 0;
    for (std::size_t v = 0; v < variables; ++v) {
      const auto& knots = axes[v].knots;
      if (!knots.empty())
        at += axes[v].stride *
              static_cast<std::size_t>(std::lower_bound(knots.begin(), knots.end(), row.point[v]) -
                                       knots.begin());
    }
    if (row_at[at] != nullptr) {
      diagnostics_.error(place(row), "time and place are those of line " +
                                         std::to_string(row_at[at]->line->number));
      return;
    }
    row_at[at] = &row;
    std::copy(row.values.begin(), row.values.end(),
              table.values_.begin() + static_cast<std::ptrdiff_t>(at * count));
  }
  const auto gap = std::find(row_at.begin(), row_at.end(), nullptr);
  if (gap == row_at.end()) return;
  const auto at = static_cast<std::size_t>(gap - row_at.begin());
  std::string where;
  for (std::size_t v = 0; v < variables; ++v) {
    const auto& knots = axes[v].knots;
    if (!knots.empty())
      where += std::string(where.empty() ? "" : ", ") + names[v] + " = " +
               write_value(knots[at / axes[v].stride % knots.size()]);
  }
  diagnostics_.error(header, "the rows do not fill a grid: none for " + where + ", and " +
                                 std::to_string(std::count(row_at.begin(), row_at.end(), nullptr)) +
                                 " missing in all");
}

}  // namespace hawser
