#include "hawser/values/table_deck.hpp"

#include <algorithm>

#include "hawser/deck/number.hpp"

namespace hawser {

Spec<TableDeck> TableDeck::spec() {
  using P = TableDeck;
  return Spec<P>("table", "How a CSV file of measured or forecast values is to be read.")
      .source("doc/tables.md")
      .attribute("name", &P::name, required(), "By which conditions ask for it.")
      .attribute("file", &P::file, required(),
                 "CSV file; the first line names columns with their units, such as time_h, x_km, "
                 "velocity_x_m_per_s. A relative path starts at the deck's folder.")
      .attribute("direction", &P::direction,
                 one_of({"coming-from", "going-to"}) && absent("the table has no such column"),
                 "What a column direction_deg means, a compass bearing: where the water comes from "
                 "or where it goes to.")
      .attribute("ignore", &P::ignore, absent("every column is read"),
                 "Columns that are not read, by the names that they have in the file.")
      .attribute("missing", &P::missing, absent("every cell must hold a value"),
                 "What stands for no value, such as -999 or NaN; an empty cell does then, too. "
                 "\"none\" says that every number is a value, however odd.")
      .attribute("longest-gap", &P::longest_gap, "s", positive() && absent("none is bridged"),
                 "The longest time without rows that is bridged by a straight line.")
      .attribute("origin", &P::origin, "m", any() && length(2) && absent("no chart positions"),
                 "Easting and northing of the place x = y = 0; x is to the east, y to the north.")
      .attribute("time-origin", &P::time_origin, "s", any(), "The table's time at t = 0.")
      .attribute("relative", &P::relative,
                 "Displacements count from where the table is at t = 0, or where it begins.")
      .attribute("smooth", &P::smooth, "s", non_negative() && absent("linear between the rows"),
                 "A smoothing spline over time: a swing of this period keeps half of its "
                 "amplitude, slower ones all, faster ones less with the fourth power of the "
                 "frequency. 0 says that the rows are meant as they are.");
}

bool TableDeck::takes_all() const {
  return std::find(missing.begin(), missing.end(), "none") != missing.end();
}

bool TableDeck::is_missing(const std::string& word) const {
  if (word.empty()) return !missing.empty() && !takes_all();
  double value = 0;
  const bool is_number = read_number(word, value).empty();
  return std::any_of(missing.begin(), missing.end(), [&](const std::string& mark) {
    double other = 0;
    return mark == word || (is_number && read_number(mark, other).empty() && other == value);
  });
}

const TableDeck* find_table(const std::vector<TableDeck>& tables, const std::string& name) {
  const auto found = std::find_if(tables.begin(), tables.end(),
                                  [&](const TableDeck& table) { return table.name.value == name; });
  return found == tables.end() ? nullptr : &*found;
}

void check_names(const std::vector<TableDeck>& tables, Diagnostics& diagnostics) {
  for (const TableDeck& table : tables)
    if (find_table(tables, table.name.value) != &table)
      diagnostics.error(table.name.location, "there are two tables '" + table.name.value + "'");
}

}  // namespace hawser
