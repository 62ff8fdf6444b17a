#pragma once
// What a deck says of <conditions>.
#include <optional>
#include <string>
#include <vector>

#include "hawser/conditions/sources.hpp"
#include "hawser/deck/spec.hpp"

namespace hawser {

/// A value on a region: at the start, or prescribed within a window of time.
struct ConditionDeck : Sources {
  std::string name;
  Located<std::string> field;
  Located<std::vector<std::string>> on;
  Located<std::string> component{"all", {}};
  std::optional<double> from, until;  ///< s
  bool replaces = false;              ///< meant to hold where earlier ones say something else
  Location location;
  static Spec<ConditionDeck> initial_spec();
  static Spec<ConditionDeck> prescribe_spec();
};

struct ConditionsDeck {
  std::vector<ConditionDeck> initial, prescribe;
  static Spec<ConditionsDeck> spec();
};

}  // namespace hawser
