#pragma once
// What a deck says of its results outside of the reports: <output>, <expect>.
#include <string>
#include <vector>

#include "hawser/deck/spec.hpp"

namespace hawser {

struct OutputDeck {
  int fields_every = 0, history_every = 1,
      checkpoint_every = 0;  ///< steps; 0: never, but fields at the end
  bool checkpoint_at_end = false;
  Location location;
  std::vector<DeckNode> reports;
  static Spec<OutputDeck> spec();
};

struct ExpectDeck {
  Located<std::string> quantity;
  double value = 0, within = 0;
  std::string why;
  static Spec<ExpectDeck> spec();
};

}  // namespace hawser
