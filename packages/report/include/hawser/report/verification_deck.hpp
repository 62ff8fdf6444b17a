#pragma once
// What a deck says about orders of accuracy.
#include <optional>
#include <string>
#include <vector>

#include "hawser/deck/spec.hpp"

namespace hawser {

/// The order with which a reported quantity, an error, must vanish.
struct OrderDeck {
  Located<std::string> quantity;
  double at_least = 0;
  std::string why;
  static Spec<OrderDeck> spec();
};

enum class Refinement { space, time, both };

/// What `hawser converge` does with the deck.
struct ConvergeDeck {
  Refinement refine = Refinement::space;
  int levels = 4;
  std::vector<OrderDeck> orders;
  static Spec<ConvergeDeck> spec();
};

/// Quantities of the <error> among a deck's reports: those that refinement is to make vanish.
std::vector<std::string> error_quantities(const std::vector<DeckNode>& reports);

}  // namespace hawser
