// UKOOA P1/90: records of 80 columns. Read are, by columns from 1:
//
//   H  2-5 type, 6-32 description, 33-80 data
//   S  (source), V (vessel) and others: 20-25 point number, 71-73 day of the year, 74-79 hhmmss
//   R  three times from 2: 4 receiver group, 9.1 easting, 9.1 northing, 4.1 cable depth; 80
//   streamer
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

#include "hawser/deck/number.hpp"
#include "src/formats.hpp"
#include "src/line_builder.hpp"

namespace hawser {
namespace {

const char* const points = "SVTGQACEZ";  ///< records of a point; a shot begins with S, or else V
constexpr double day = 86400;            // s

std::string trimmed(const std::string& text) {
  const auto from = text.find_first_not_of(' ');
  if (from == std::string::npos) return "";
  return text.substr(from, text.find_last_not_of(' ') - from + 1);
}

class Reader {
 public:
  Reader(const std::string& text, const std::string& file, const NavigationOptions& options,
         Diagnostics& diagnostics)
      : text_(text),
        file_(file),
        options_(options),
        diagnostics_(diagnostics),
        before_(diagnostics.error_count()),
        builder_(file, "P1/90", diagnostics) {}

  NavigationLine read() {
    // With sources at all, they are the shots; else the vessel.
    shot_mark_ = ("\n" + text_).find("\nS") == std::string::npos ? 'V' : 'S';
    for (std::size_t begin = 0; begin < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      record_ = text_.substr(begin, end - begin);
      while (!record_.empty() && (record_.back() == '\r' || record_.back() == ' '))
        record_.pop_back();
      begin = end + 1;
      ++number_;
      if (diagnostics_.error_count() >= before_ + 5) break;
      if (!record_.empty()) read_record();
    }
    return diagnostics_.error_count() > before_ ? NavigationLine() : builder_.finish();
  }

 private:
  void fault(std::size_t column, const std::string& sentence) {
    diagnostics_.error({file_, number_, static_cast<int>(column)}, sentence);
  }
  std::string field(std::size_t column, std::size_t width) const {
    return column > record_.size() ? "" : trimmed(record_.substr(column - 1, width));
  }
  /// NaN, and a fault, where it is none.
  double number(std::size_t column, std::size_t width, const char* what) {
    double value = no_value;
    const std::string text = field(column, width);
    const std::string wrong = text.empty() ? "the columns are empty" : read_number(text, value);
    if (!wrong.empty())
      fault(column, std::string(what) + " stands in columns " + std::to_string(column) + " to " +
                        std::to_string(column + width - 1) + ", and " + quoted(text) +
                        " is no number: " + wrong);
    return value;
  }

  void read_record() {
    const char mark = record_[0];
    if (record_.size() > 80) return fault(81, "a record of P1/90 has 80 columns");
    if (mark == 'H') return read_header();
    if (mark == 'R') return read_receivers();
    if (record_.compare(0, 3, "EOF") == 0) return;
    if (std::strchr(points, mark) == nullptr)
      return fault(1, "there is no record " + quoted(std::string(1, mark)) +
                          " in P1/90; there are H, R, and of points S V T G Q A C E Z");
    if (mark == shot_mark_) read_shot();
  }

  void read_header() {
    const std::string type = field(2, 4);
    if (type == "1600" || (type.size() == 4 && type >= "1400" && type < "2500"))
      builder_.line().header.push_back(record_);
    if (type == "2001" && field(33, 48).find_first_of("0123456789") != std::string::npos) {
      const std::string factor = field(33, 48);
      const std::size_t from = factor.find_first_of("0123456789");
      const std::size_t size = factor.find_first_not_of("0123456789.", from) - from;
      double value = 1;
      if (read_number(factor.substr(from, size), value).empty() && value != 1)
        fault(33, "the grid is not in metres, but in units of " + factor.substr(from, size) +
                      " m, which is not read");
    }
  }

  void read_shot() {
    const double point = number(20, 6, "the point number");
    double time = no_value;
    if (!field(71, 9).empty()) {
      const double of_year = number(71, 3, "the day of the year");
      const double hours = number(74, 2, "the hour"), minutes = number(76, 2, "the minute");
      const double seconds = number(78, 2, "the second");
      time = of_year * day + hours * 3600 + minutes * 60 + seconds;
      // Over New Year the day begins again.
      if (time + 300 * day < last_time_) time += 365 * day;
      last_time_ = time;
    }
    if (std::isnan(point)) return;
    builder_.shot(static_cast<int>(point), time, {file_, number_, 20});
    has_shot_ = true;
  }

  void read_receivers() {
    if (!has_shot_) return fault(1, "receivers stand before the first shot they would belong to");
    const std::string streamer = field(80, 1);
    if (options_.streamer && streamer != std::to_string(*options_.streamer)) return;
    if (!options_.streamer && seen_ && streamer != streamer_)
      return fault(80, "there are several streamers, " + quoted(streamer_) + " and " +
                           quoted(streamer) + "; --streamer says which one is meant");
    streamer_ = streamer;
    seen_ = true;
    for (const std::size_t at : {2U, 28U, 54U}) {
      if (field(at, 26).empty()) continue;
      const double group = number(at, 4, "the receiver group");
      const double east = number(at + 4, 9, "the easting"),
                   north = number(at + 13, 9, "the northing");
      const double depth =
          field(at + 22, 4).empty() ? no_value : number(at + 22, 4, "the cable's depth");
      if (!std::isnan(group))
        builder_.receiver(static_cast<int>(group), {east, north}, depth,
                          {file_, number_, static_cast<int>(at)});
    }
  }

  const std::string& text_;
  const std::string file_;
  const NavigationOptions& options_;
  Diagnostics& diagnostics_;
  const std::size_t before_;
  LineBuilder builder_;
  std::string record_, streamer_;
  int number_ = 0;
  char shot_mark_ = 'S';
  bool has_shot_ = false, seen_ = false;
  double last_time_ = 0;  // s
};

}  // namespace

bool is_p190(const std::string& text) {
  return text.size() > 5 && text[0] == 'H' &&
         std::all_of(text.begin() + 1, text.begin() + 5,
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

NavigationLine read_p190(const std::string& text, const std::string& file,
                         const NavigationOptions& options, Diagnostics& diagnostics) {
  return Reader(text, file, options, diagnostics).read();
}

}  // namespace hawser
