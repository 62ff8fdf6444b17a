#pragma once
// What a deck says about exact solutions and orders of accuracy.
#include <optional>
#include <string>
#include <vector>

#include "hawser/deck/spec.hpp"

namespace hawser {

/// The difference between a field and its exact solution, measured at the end of the run.
struct ErrorDeck {
  std::string name;
  Located<std::string> field, on;
  Located<Expressions> exact;
  bool up_to_constant = false;
  static Spec<ErrorDeck> spec();
};

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

}  // namespace hawser
