// A line as a table: a row per receiver and shot.
#include <cmath>
#include <map>

#include "hawser/values/number_columns.hpp"
#include "src/formats.hpp"
#include "src/line_builder.hpp"

namespace hawser {
namespace {

enum Known : std::size_t { shot, receiver, east, north, time, arc_length, depth };

std::vector<KnownColumn> known_columns() {
  return {{{"shot", "shot_point", "sp"}, "1", true, false},
          {{"receiver", "channel", "group"}, "1", true, false},
          {{"east", "easting", "x"}, "m", true, true},
          {{"north", "northing", "y"}, "m", true, true},
          {{"time", "t"}, "s", false, false},
          {{"arc_length", "offset"}, "m", false, false},
          {{"depth"}, "m", false, true}};
}

class Reader {
 public:
  Reader(const Csv& csv, const NumberColumns& columns, Diagnostics& diagnostics)
      : csv_(csv),
        columns_(columns),
        diagnostics_(diagnostics),
        builder_(csv.file, "CSV", diagnostics) {}

  NavigationLine read() {
    const std::size_t before = diagnostics_.error_count();
    for (std::size_t row = 0; row < csv_.rows.size(); ++row) {
      if (diagnostics_.error_count() >= before + most_told) break;
      read(row);
    }
    NavigationLine line = builder_.finish();
    if (!columns_.given[arc_length]) return line;
    for (const int number : line.receivers)
      line.arc_lengths.push_back(arc_lengths_.at(number));
    return line;
  }

 private:
  double value(Known column, std::size_t row) const {
    return columns_.given[column] ? columns_.values[column][row] : no_value;
  }
  Location place(Known column, std::size_t row) const {
    return csv_.place(csv_.rows[row], columns_.cells[column]);
  }
  int whole(Known column, std::size_t row) {
    const double given = value(column, row);
    if (std::abs(given) > 1e9 || given != std::rint(given)) {
      diagnostics_.error(place(column, row),
                         "the number of a " + known_columns()[column].names[0] + " is whole");
      return 0;
    }
    return static_cast<int>(given);
  }

  void read(std::size_t row) {
    const int number = whole(shot, row), group = whole(receiver, row);
    if (row == 0 || number != last_shot_) builder_.shot(number, value(time, row), place(shot, row));
    last_shot_ = number;
    const double now = value(time, row), of_shot = builder_.line().shots.back().time;
    if (now != of_shot && !std::isnan(now))
      diagnostics_.error(place(time, row),
                         "the time is another one than that of the shot's first row");
    builder_.receiver(group, {value(east, row), value(north, row)}, value(depth, row),
                      place(receiver, row));
    if (!columns_.given[arc_length]) return;
    const auto [known, is_new] = arc_lengths_.emplace(group, value(arc_length, row));
    if (!is_new && known->second != value(arc_length, row))
      diagnostics_.error(place(arc_length, row),
                         "the arc length of receiver " + std::to_string(group) + " changes");
  }

  const Csv& csv_;
  const NumberColumns& columns_;
  Diagnostics& diagnostics_;
  LineBuilder builder_;
  int last_shot_ = 0;
  std::map<int, double> arc_lengths_;
};

}  // namespace

NavigationLine read_csv_line(const std::string& text, const std::string& file,
                             Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.error_count();
  const Csv csv = read_csv(text, file, diagnostics);
  if (diagnostics.error_count() > before) return {};
  const NumberColumns columns = read_number_columns(csv, known_columns(), diagnostics);
  if (diagnostics.error_count() > before) return {};
  return Reader(csv, columns, diagnostics).read();
}

}  // namespace hawser
