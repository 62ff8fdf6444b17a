#pragma once
// A deck's parameters: values with names, for use in every number and formula of the deck.
//
//   <parameter name="tow_speed" value="0.2 m/s" meaning="of the ship over ground"/>
#include <optional>
#include <string>
#include <vector>

#include "hawser/deck/location.hpp"
#include "hawser/deck/unit.hpp"

namespace hawser {

struct NamedValue {
  std::string name;
  double value = 0;          ///< SI
  double given = 0;          ///< in `unit`
  std::optional<Unit> unit;  ///< when the deck gives one; else the dimension is not known
  Location location;
};

using NamedValues = std::vector<NamedValue>;

/// Null when there is none, or no names at all.
const NamedValue* find_named(const NamedValues* names, const std::string& name);

}  // namespace hawser
