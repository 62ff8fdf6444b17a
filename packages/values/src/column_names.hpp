#pragma once
// The names that columns of a table may have.
#include <string>
#include <vector>

#include "hawser/values/column.hpp"

namespace hawser {

/// A quantity by one of its names; the first of a quantity is the one that messages show.
struct Named {
  std::string name, unit;
  TableQuantity quantity;
};

/// All that a table may hold that is asked for these values.
std::vector<Named> known_to(const WantedValues& wanted);

/// The quantity whose name is the longest beginning of the column's, up to a '_', blank or bracket.
const Named* quantity_of(const std::string& column, const std::vector<Named>& known);

/// What follows the quantity in a column's name, as a unit: "_m_per_s2" and " [m/s^2]" are "m/s^2".
std::string unit_text(std::string ending);

/// "velocity_x_m_per_s"
std::string with_unit(const std::string& name, std::string unit);
std::string with_unit(const Named& named);

}  // namespace hawser
