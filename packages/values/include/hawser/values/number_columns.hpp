#pragma once
// A CSV file of plain numbers whose columns are told by quantity and unit, whatever their order:
// "east_m", "time_h". For what is read once and is no source of values over time and place.
#include <string>
#include <vector>

#include "hawser/values/csv.hpp"

namespace hawser {

/// What a column may hold.
struct KnownColumn {
  std::vector<std::string> names;  ///< the first is the one that messages show
  std::string unit;                ///< in which its numbers arrive; "1": the name stands alone
  bool needed = false;
  bool may_be_empty = false;  ///< an empty cell is no value, NaN
};

struct NumberColumns {
  std::vector<bool> given;                  ///< per known column
  std::vector<std::vector<double>> values;  ///< [known column][row]; empty where not given
  std::vector<std::size_t> cells;           ///< per known column, its cell in a line
};

/// Faults: unknown, doubled and missing columns, no unit or one of another dimension, a cell that
/// is no number. After a fault what is returned is not to be used.
NumberColumns read_number_columns(const Csv& csv, const std::vector<KnownColumn>& known,
                                  Diagnostics& diagnostics);

}  // namespace hawser
