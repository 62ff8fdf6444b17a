#include "src/table_rows.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "hawser/base/constants.hpp"
#include "hawser/deck/number.hpp"
#include "hawser/deck/value.hpp"

namespace hawser {
namespace {

using Kind = TableQuantity::Kind;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_hexadecimal(const std::string& text) {
  const std::size_t sign = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  return lower(text).compare(sign, 2, "0x") == 0;
}

/// 2024-05-01, 12:30:00, 01.05.2024
bool is_date(const std::string& text) {
  const bool digits = std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isdigit(c) != 0 ||
           std::string("-:./TZ +").find(static_cast<char>(c)) != std::string::npos;
  });
  const auto count = [&](char c) { return std::count(text.begin(), text.end(), c); };
  return digits && (count(':') > 0 || count('-') > 1 || count('.') > 1 || count('/') > 0);
}

std::string number_fault(const std::string& text, const std::string& reason) {
  if (text.empty())
    return "the cell is empty; where values are missing, missing of <table> says what stands for "
           "them";
  if (is_hexadecimal(text)) return quoted(text) + " is hexadecimal; a decimal number is needed";
  for (const char* mark : {"nan", "na", "n/a", "null", "none", "-", "--", "inf", "-inf", "missing"})
    if (lower(text) == mark)
      return quoted(text) +
             " is no number; where it stands for a missing value, <table missing=\"" + text +
             "\"> says so";
  if (is_date(text))
    return quoted(text) + " is a date or a time of day; a number in the column's unit is needed";
  return quoted(text) + " is no number: " + reason;
}

/// What instruments and models write for "no value": -999, 9999.0, 99.99, 32767, ...
bool looks_like_fill(const std::string& text) {
  std::string digits = text;
  if (digits[0] == '-' || digits[0] == '+') digits.erase(0, 1);
  const std::size_t point = digits.find('.');
  if (point != std::string::npos) {
    digits.erase(digits.find_last_not_of('0') + 1);
    digits.erase(point, 1);
  }
  if (digits == "32767" || digits == "32768") return true;
  return digits.size() >= 3 && digits.find_first_not_of('9') == std::string::npos;
}

class RowReader {
 public:
  RowReader(const Csv& csv, const std::vector<TableColumn>& columns, const TableDeck& deck,
            const WantedValues& wanted, Diagnostics& diagnostics)
      : csv_(csv), columns_(columns), deck_(deck), wanted_(wanted), diagnostics_(diagnostics) {}

  TableRows read() {
    bool components = false, speed = false;
    for (const TableColumn& column : columns_) {
      const TableQuantity& q = column.quantity;
      if (q.kind == Kind::time) result_.has[0] = true;
      if (q.kind == Kind::place) result_.has[1 + q.index] = true;
      components = components || q.kind == Kind::component;
      speed = speed || q.kind == Kind::speed;
    }
    result_.is_position = wanted_.is_place && !components && !speed;
    ordinary_.assign(columns_.size(), 0);
    odd_.assign(columns_.size(), {});
    for (const CsvLine& line : csv_.rows)
      if (told_ < most_told) read(line);
    for (std::size_t c = 0; c < columns_.size() && told_ == 0; ++c)
      check_fill(c);
    if (result_.is_position) result_.has = {true, false, false, false};
    return std::move(result_);
  }

 private:
  struct Odd {
    const CsvLine* line = nullptr;
    double least = 0;
  };

  void fault(const CsvLine& line, std::size_t cell, const std::string& sentence) {
    diagnostics_.error(csv_.place(line, cell), sentence);
    ++told_;
  }

  void read(const CsvLine& line) {
    TableRow row{&line, {}, std::vector<double>(wanted_.count, 0)};
    double speed = 0, direction = 0;
    bool has_direction = false, complete = true;
    std::vector<double> place(3, 0);
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const TableQuantity& q = columns_[c].quantity;
      if (q.kind == Kind::ignored) continue;
      double value = 0;
      const int before = told_;
      if (!read(line, c, value)) {
        complete = false;
        if (told_ == before &&
            (q.kind == Kind::time || (q.kind == Kind::place && !result_.is_position)))
          fault(line, columns_[c].cell,
                "a row without a time or place cannot be used; take it away");
        continue;
      }
      switch (q.kind) {
        case Kind::time: row.point[0] = value - deck_.time_origin; break;
        case Kind::place:
          place[q.index] = value - (q.chart && deck_.origin ? deck_.origin->value[q.index] : 0);
          break;
        case Kind::component:
          if (q.index >= wanted_.first && q.index < wanted_.first + wanted_.count)
            row.values[q.index - wanted_.first] = value;
          break;
        case Kind::speed: speed = value; break;
        case Kind::direction: direction = value, has_direction = true; break;
        case Kind::ignored: break;
      }
    }
    if (!complete) {
      result_.without_value.push_back(&line);
      return;
    }
    if (has_direction) {
      const double sign = deck_.direction->value == "coming-from" ? -1 : 1;
      const double vector[] = {sign * speed * std::sin(direction),
                               sign * speed * std::cos(direction)};
      for (std::size_t i = 0; i < wanted_.count; ++i)
        row.values[i] = vector[wanted_.first + i];
    }
    for (std::size_t i = 0; i < 3; ++i)
      row.point[1 + i] = result_.is_position ? 0 : place[i];
    for (std::size_t i = 0; result_.is_position && i < wanted_.count; ++i)
      row.values[i] = place[wanted_.first + i];
    result_.rows.push_back(std::move(row));
  }

  /// False when there is no value, by a fault or because it is missing.
  bool read(const CsvLine& line, std::size_t c, double& value) {
    const TableColumn& column = columns_[c];
    const std::string& text = line.cells[column.cell].text;
    if (deck_.is_missing(text)) return false;
    double number = 0;
    const std::string reason = text.empty() ? "" : read_number(text, number);
    if (text.empty() || !reason.empty()) {
      fault(line, column.cell, number_fault(text, reason));
      return false;
    }
    value = number * column.factor;
    if (deck_.takes_all()) return true;
    const TableQuantity& q = column.quantity;
    // The round-off of a factor is no fault.
    if (value < q.least * (1 + 1e-12) || value > q.most * (1 + 1e-12)) {
      const bool angle = q.kind == Kind::direction;
      const double unit = angle ? pi / 180 : 1;
      fault(line, column.cell,
            "'" + column.name + "' is " + quoted(text) + ", and " +
                (angle ? "-360 to 360 degrees"
                       : write_value(q.least / unit) + " to " + write_value(q.most / unit) +
                             (q.kind == Kind::time    ? " s"
                              : q.kind == Kind::speed ? " m/s"
                              : q.kind == Kind::place ? " m"
                                                      : " " + wanted_.unit)) +
                " is plausible: is the unit right, or does it stand for a missing value? Then "
                "<table missing=\"" +
                text + "\"> says so, and missing=\"none\" that it is a value");
      return false;
    }
    if (!looks_like_fill(text))
      ordinary_[c] = std::max(ordinary_[c], std::abs(number));
    else if (odd_[c].line == nullptr || std::abs(number) < odd_[c].least)
      odd_[c] = {odd_[c].line == nullptr ? &line : odd_[c].line, std::abs(number)};
    return true;
  }

  /// Three times as far out as all others, it is no measurement.
  void check_fill(std::size_t c) {
    if (odd_[c].line == nullptr || odd_[c].least <= 3 * ordinary_[c] || result_.rows.size() < 2)
      return;
    const std::string& text = odd_[c].line->cells[columns_[c].cell].text;
    fault(*odd_[c].line, columns_[c].cell,
          quoted(text) + " looks like a fill value, the others in '" + columns_[c].name +
              "' go up to " + write_value(ordinary_[c]) + ": <table missing=\"" + text +
              "\"> says that there is no value, and missing=\"none\" that it is one");
  }

  const Csv& csv_;
  const std::vector<TableColumn>& columns_;
  const TableDeck& deck_;
  const WantedValues& wanted_;
  Diagnostics& diagnostics_;
  TableRows result_;
  std::vector<double> ordinary_;  // per column, the greatest as written
  std::vector<Odd> odd_;          // per column
  int told_ = 0;
};

}  // namespace

TableRows read_rows(const Csv& csv, const std::vector<TableColumn>& columns, const TableDeck& deck,
                    const WantedValues& wanted, Diagnostics& diagnostics) {
  return RowReader(csv, columns, deck, wanted, diagnostics).read();
}

}  // namespace hawser
