#include "hawser/values/number_columns.hpp"

#include <limits>

#include "hawser/deck/number.hpp"
#include "src/column_names.hpp"

namespace hawser {
namespace {

/// Every name of every known column; `index` says of which.
std::vector<Named> all_names(const std::vector<KnownColumn>& known) {
  std::vector<Named> names;
  for (std::size_t k = 0; k < known.size(); ++k)
    for (const std::string& name : known[k].names) {
      TableQuantity quantity;
      quantity.index = k;
      names.push_back({name, known[k].unit, quantity});
    }
  return names;
}

/// The column's factor to the known unit; "" or what is wrong with its name.
std::string unit_of(const std::string& column, const Named& named, double& factor) {
  const std::string text = unit_text(column.substr(named.name.size()));
  Unit unit, known;
  read_unit(named.unit, known);
  if (text.empty())
    return known.is_plain_number() ? ""
                                   : "the column '" + column + "' says no unit; '" +
                                         with_unit(named) + "' would be in " + named.unit;
  const std::string wrong = read_unit(text, unit);
  if (!wrong.empty())
    return "the column '" + column + "' ends in no unit, as '" + with_unit(named) +
           "' does: " + wrong;
  if (!same_dimension(unit, known))
    return "the column '" + column + "' is in " + unit.text + ", and " + named.name +
           " is a quantity in " + named.unit + ", such as '" + with_unit(named) + "'";
  factor = unit.factor / known.factor;
  return "";
}

}  // namespace

NumberColumns read_number_columns(const Csv& csv, const std::vector<KnownColumn>& known,
                                  Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.error_count();
  NumberColumns result{std::vector<bool>(known.size(), false),
                       std::vector<std::vector<double>>(known.size()),
                       std::vector<std::size_t>(known.size(), 0)};
  const std::vector<Named> names = all_names(known);
  std::vector<std::string> allowed;
  for (const KnownColumn& column : known)
    allowed.push_back(with_unit(column.names.front(), column.unit));
  std::vector<double> factors(known.size(), 1);
  for (std::size_t cell = 0; cell < csv.header.cells.size(); ++cell) {
    const std::string& name = csv.header.cells[cell].text;
    const auto fault = [&](const std::string& sentence) {
      diagnostics.error(csv.place(csv.header, cell), sentence);
    };
    const Named* const named = quantity_of(name, names);
    if (named == nullptr) {
      fault("there is no column " + quoted(name) + "; allowed: " + listed(allowed) +
            did_you_mean(name, allowed));
      continue;
    }
    const std::size_t k = named->quantity.index;
    const std::string wrong = unit_of(name, *named, factors[k]);
    if (!wrong.empty())
      fault(wrong);
    else if (result.given[k])
      fault("'" + name + "' and '" + csv.header.cells[result.cells[k]].text +
            "' hold the same quantity; take one away");
    result.given[k] = true;
    result.cells[k] = cell;
  }
  for (std::size_t k = 0; k < known.size(); ++k)
    if (known[k].needed && !result.given[k])
      diagnostics.error(csv.place(csv.header, csv.header.cells.size() - 1),
                        "a column is missing: " + allowed[k] + "; there may be " + listed(allowed));
  if (diagnostics.error_count() > before) return result;
  int told = 0;
  for (const CsvLine& line : csv.rows)
    for (std::size_t k = 0; k < known.size() && told < most_told; ++k) {
      if (!result.given[k]) continue;
      const std::string& text = line.cells[result.cells[k]].text;
      double value = std::numeric_limits<double>::quiet_NaN();
      const bool empty = text.empty() && known[k].may_be_empty;
      const std::string wrong = empty ? "" : read_number(text, value);
      if (!wrong.empty()) {
        diagnostics.error(csv.place(line, result.cells[k]),
                          text.empty() ? "the cell is empty; a number is needed"
                                       : quoted(text) + " is no number: " + wrong);
        ++told;
      }
      result.values[k].push_back(value * factors[k]);
    }
  return result;
}

}  // namespace hawser
