#pragma once
// What a column of a table holds, told by its name: a quantity and a unit, as time_h, x_km,
// speed_kn, velocity_x_m_per_s, "velocity_x [m/s]".
#include <string>
#include <vector>

#include "hawser/deck/unit.hpp"
#include "hawser/values/csv.hpp"
#include "hawser/values/table_deck.hpp"

namespace hawser {

/// What a table is asked for: components of a field.
struct WantedValues {
  std::string field, unit;
  std::vector<std::string> components;  ///< names of all: x, y; one empty name for a scalar
  std::size_t first = 0, count = 1;     ///< the ones that are wanted
  bool is_place = false;                ///< a displacement: positions of a point will do as well
};

struct TableQuantity {
  enum class Kind { time, place, component, speed, direction, ignored };
  Kind kind = Kind::ignored;
  std::size_t index = 0;       ///< of a place, x y z; of a component
  bool chart = false;          ///< a place counted from a chart's origin
  double least = 0, most = 0;  ///< what is plausible, in SI units
};

struct TableColumn {
  TableQuantity quantity;
  double factor = 1;  ///< to SI units
  std::size_t cell = 0;
  std::string name;
};

/// One per column of the file. Faults, with the nearest name and the header as it should be:
/// unknown, doubled and missing columns, no unit, a unit of another dimension.
std::vector<TableColumn> read_columns(const Csv& csv, const TableDeck& deck,
                                      const WantedValues& wanted, Diagnostics& diagnostics);

}  // namespace hawser
