#include "hawser/values/column.hpp"

#include <algorithm>
#include <cctype>

#include "hawser/base/constants.hpp"
#include "src/column_names.hpp"

namespace hawser {
namespace {

using Kind = TableQuantity::Kind;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

class Reader {
 public:
  Reader(const Csv& csv, const TableDeck& deck, const WantedValues& wanted,
         Diagnostics& diagnostics)
      : csv_(csv),
        deck_(deck),
        wanted_(wanted),
        known_(known_to(wanted)),
        diagnostics_(diagnostics) {}

  std::vector<TableColumn> read() {
    const std::size_t before = diagnostics_.error_count();
    for (std::size_t i = 0; i < csv_.header.cells.size(); ++i)
      columns_.push_back(read(i));
    check_ignored();
    if (diagnostics_.error_count() == before) check_completeness();
    return columns_;
  }

 private:
  void fault(std::size_t cell, const std::string& sentence) {
    diagnostics_.error(csv_.place(csv_.header, cell), sentence);
  }
  const std::string& name(std::size_t cell) const { return csv_.header.cells[cell].text; }
  /// The first column of that kind; null when there is none.
  const TableColumn* find(Kind kind) const {
    const auto found = std::find_if(columns_.begin(), columns_.end(),
                                    [&](const TableColumn& c) { return c.quantity.kind == kind; });
    return found == columns_.end() ? nullptr : &*found;
  }

  TableColumn read(std::size_t cell) {
    TableColumn column{{}, 1, cell, name(cell)};
    const auto& ignored = deck_.ignore;
    if (std::find(ignored.begin(), ignored.end(), column.name) != ignored.end()) return column;
    const Named* const named = quantity_of(column.name, known_);
    if (named == nullptr) {
      unknown(cell);
      return column;
    }
    const std::string text = unit_text(column.name.substr(named->name.size()));
    Unit unit, si;
    read_unit(named->unit, si);
    if (text.empty() && !si.is_plain_number()) {
      fault(cell,
            "the column '" + column.name + "' says no unit; the header would be " + right_header());
      return column;
    }
    const std::string wrong = text.empty() ? "" : read_unit(text, unit);
    if (!wrong.empty()) {
      fault(cell, "the column '" + column.name + "' ends in no unit, as '" + with_unit(*named) +
                      "' does: " + wrong);
      return column;
    }
    if (!same_dimension(unit, si)) {
      fault(cell, "the column '" + column.name + "' is in " + unit.text + ", and " + named->name +
                      " is a quantity in " + named->unit + ", such as '" + with_unit(*named) + "'");
      return column;
    }
    column.quantity = named->quantity;
    column.factor = unit.factor / si.factor * (named->unit == "deg" ? pi / 180 : 1);
    for (const TableColumn& other : columns_)
      if (other.quantity.kind == column.quantity.kind &&
          other.quantity.index == column.quantity.index)
        fault(cell, "the columns '" + other.name + "' and '" + column.name +
                        "' hold the same quantity; take one away, or name it in ignore of <table>");
    return column;
  }

  void check_ignored() {
    std::vector<std::string> names;
    for (const CsvCell& cell : csv_.header.cells)
      names.push_back(cell.text);
    for (const std::string& ignored : deck_.ignore)
      if (std::find(names.begin(), names.end(), ignored) == names.end())
        diagnostics_.error(deck_.name.location, "ignore names the column " + quoted(ignored) +
                                                    ", and " + csv_.file + " has " + listed(names) +
                                                    did_you_mean(ignored, names));
  }

  void unknown(std::size_t cell) {
    std::vector<std::string> names, shown;
    for (const Named& named : known_) {
      names.push_back(with_unit(named));
      if (named.name.size() > 1 || named.quantity.kind == Kind::place)
        shown.push_back(names.back());
    }
    const std::string& given = name(cell);
    if (given.empty()) return fault(cell, "a column has no name; allowed: " + listed(shown));
    const std::string nearest = nearest_name(given, names);
    const char first = given[0];
    const bool number = is_digit(first) || ((first == '-' || first == '.') && given.size() > 1);
    fault(cell, number ? quoted(given) +
                             " stands where a column's name is needed; the first line names the "
                             "columns with their units, such as " +
                             shown.front() + "," + with_unit(wanted_name(0), wanted_.unit)
                       : "there is no column " + quoted(given) + "; allowed: " + listed(shown) +
                             ", and what ignore of <table> names" +
                             (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
  }

  std::string wanted_name(std::size_t i) const {
    const std::string& component = wanted_.components[wanted_.first + i];
    return wanted_.field + (component.empty() ? "" : "_" + component);
  }

  /// The header of this file, with the SI unit where a column has none.
  std::string right_header() const {
    std::string header;
    for (const CsvCell& cell : csv_.header.cells) {
      const Named* const named = quantity_of(cell.text, known_);
      const bool bare = named != nullptr && named->name == cell.text;
      header += (header.empty() ? "" : ",") + (bare ? with_unit(*named) : cell.text);
    }
    return "'" + header + "', if that is what its numbers are in";
  }

  bool is_wanted(const TableColumn& column) const {
    const TableQuantity& q = column.quantity;
    return q.kind == Kind::component && q.index >= wanted_.first &&
           q.index < wanted_.first + wanted_.count;
  }

  void check_completeness() {
    const TableColumn* const speed = find(Kind::speed);
    const TableColumn* const direction = find(Kind::direction);
    const TableColumn* const place = find(Kind::place);
    if (find(Kind::time) == nullptr && place == nullptr)
      return fault(0, "no column says when or where; add time_s, or x_m and y_m");
    check_chart();
    if (speed != nullptr || direction != nullptr) return check_vector(speed, direction);
    if (deck_.direction)
      diagnostics_.error(deck_.direction->location,
                         "there is no column direction_deg in " + csv_.file);
    const auto given = std::count_if(columns_.begin(), columns_.end(),
                                     [&](const TableColumn& column) { return is_wanted(column); });
    // A component that was not asked for says that this is no table of positions.
    if (wanted_.is_place && place != nullptr && find(Kind::component) == nullptr)
      return check_positions();
    std::string missing;
    for (std::size_t i = 0; i < wanted_.count; ++i)
      if (std::none_of(columns_.begin(), columns_.end(), [&](const TableColumn& column) {
            return is_wanted(column) && column.quantity.index == wanted_.first + i;
          }))
        missing += (missing.empty() ? "" : ", ") + with_unit(wanted_name(i), wanted_.unit);
    if (missing.empty()) return;
    std::string others;
    if (wanted_.field == "velocity" && given == 0) others = ", or speed_m_per_s and direction_deg";
    if (wanted_.is_place && given == 0) others = ", or x_m and y_m, the positions of a point";
    fault(csv_.header.cells.size() - 1, "a column is missing: " + missing + others);
  }

  void check_chart() {
    const TableColumn* chart = nullptr;
    for (const TableColumn& column : columns_)
      if (column.quantity.chart && chart == nullptr) chart = &column;
    if (chart != nullptr && !deck_.origin && !(deck_.relative && wanted_.is_place))
      fault(chart->cell,
            "'" + chart->name +
                "' counts from a chart's origin: <table origin=\"E N\"> must say where "
                "x = y = 0 is on it" +
                (wanted_.is_place ? ", or relative=\"true\" counts from where the track begins"
                                  : ""));
    if (chart == nullptr && deck_.origin)
      diagnostics_.error(
          deck_.origin->location,
          "origin belongs to columns easting_m and northing_m, and " + csv_.file + " has none");
  }

  void check_vector(const TableColumn* speed, const TableColumn* direction) {
    const TableColumn& one = speed == nullptr ? *direction : *speed;
    Unit unit, of_speed;
    read_unit("m/s", of_speed);
    if (!read_unit(wanted_.unit, unit).empty() || !same_dimension(unit, of_speed) ||
        wanted_.components.size() < 2)
      return fault(one.cell,
                   "'" + one.name + "': a speed and a direction make a velocity, and the field '" +
                       wanted_.field + "' is in " + wanted_.unit + "; needed: " + needed());
    if (speed == nullptr || direction == nullptr)
      return fault(one.cell, "'" + one.name + "' needs a column " +
                                 (speed == nullptr ? "speed_m_per_s" : "direction_deg") +
                                 " beside it: a speed and a direction make a vector");
    for (const TableColumn& column : columns_)
      if (column.quantity.kind == Kind::component && column.quantity.index < 2)
        return fault(column.cell,
                     "'" + column.name + "' and '" + speed->name +
                         "' say the same twice; name one of them in ignore of <table>");
    if (wanted_.first + wanted_.count > 2)
      return fault(speed->cell, "a speed and a direction make a vector in the plane, and " +
                                    std::to_string(wanted_.count) + " components are needed");
    if (!deck_.direction)
      fault(direction->cell,
            "is '" + direction->name +
                "' where it comes from or where it goes to? The deck must say: <table name=\"...\" "
                "file=\"...\" direction=\"coming-from\"/> or \"going-to\"");
  }

  void check_positions() {
    for (std::size_t i = 0; i < wanted_.count; ++i) {
      const std::size_t index = wanted_.first + i;
      if (std::none_of(columns_.begin(), columns_.end(), [&](const TableColumn& column) {
            return column.quantity.kind == Kind::place && column.quantity.index == index;
          }))
        fault(csv_.header.cells.size() - 1, "a column is missing: " + std::string(1, "xyz"[index]) +
                                                "_m of the point's position");
    }
    if (find(Kind::time) == nullptr) fault(0, "no column says when the point is there; add time_s");
  }

  std::string needed() const {
    std::string result;
    for (std::size_t i = 0; i < wanted_.count; ++i)
      result += (i == 0 ? "" : ", ") + with_unit(wanted_name(i), wanted_.unit);
    return result + (wanted_.is_place ? ", or x_m, y_m, the positions of a point" : "");
  }

  const Csv& csv_;
  const TableDeck& deck_;
  const WantedValues& wanted_;
  const std::vector<Named> known_;
  Diagnostics& diagnostics_;
  std::vector<TableColumn> columns_;
};

}  // namespace

std::vector<TableColumn> read_columns(const Csv& csv, const TableDeck& deck,
                                      const WantedValues& wanted, Diagnostics& diagnostics) {
  return Reader(csv, deck, wanted, diagnostics).read();
}

}  // namespace hawser
