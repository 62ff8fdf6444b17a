#pragma once
// The rows of a table as numbers in SI units, each checked for what it can be.
#include <array>
#include <vector>

#include "hawser/values/column.hpp"

namespace hawser {

struct TableRow {
  const CsvLine* line;
  std::array<double, 4> point{};  ///< t (s), x, y, z (m); 0 where there is no such column
  std::vector<double> values;     ///< of the wanted components
};

struct TableRows {
  std::vector<TableRow> rows;
  std::array<bool, 4> has{};                  ///< a column of t, x, y, z
  std::vector<const CsvLine*> without_value;  ///< lines left out, in which a value is missing
  bool is_position = false;                   ///< the values are where a point is
};

/// Faults: what is no number, out of a plausible range, or like a fill value.
TableRows read_rows(const Csv& csv, const std::vector<TableColumn>& columns, const TableDeck& deck,
                    const WantedValues& wanted, Diagnostics& diagnostics);

}  // namespace hawser
