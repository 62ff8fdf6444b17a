#pragma once
// What a deck says of <start>: where a run begins.
#include <optional>
#include <string>

#include "hawser/deck/spec.hpp"

namespace hawser {

/// How the state at rest is found at which a run begins.
struct EquilibriumDeck {
  std::optional<double> tolerance;        ///< of Newton's method; the solver's when empty
  int max_iterations = 50;                ///< of Newton's method, per solve
  std::optional<double> relaxation_step;  ///< s, the first one; that of <time> when empty
  static Spec<EquilibriumDeck> spec();
};

struct StartDeck {
  std::optional<Located<std::string>> from;  ///< another run's checkpoint
  bool continues_time = false;
  std::optional<EquilibriumDeck> equilibrium;
  Location location;
  static Spec<StartDeck> spec();
};

}  // namespace hawser
