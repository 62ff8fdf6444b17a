#pragma once
// What a deck says of <start>: where a run begins.
#include <optional>
#include <string>
#include <vector>

#include "hawser/deck/spec.hpp"

namespace hawser {

/// A series of steady states, from a parameter's easier value to its own.
struct ContinuationDeck {
  Located<std::string> parameter;  ///< by name
  Located<Expression> from;        ///< SI
  int steps = 10;                  ///< as many at first
  bool geometric = false;          ///< equal ratios instead of equal differences
  static Spec<ContinuationDeck> spec();
  /// Told where the deck has no such parameter or its value leads nowhere.
  void check(const NamedValues* parameters, Diagnostics& diagnostics) const;
};

/// How the state at rest is found at which a run begins.
struct EquilibriumDeck {
  std::optional<double> tolerance;        ///< of Newton's method; the solver's when empty
  int max_iterations = 50;                ///< of Newton's method, per solve
  std::optional<double> relaxation_step;  ///< s, the first one; that of <time> when empty
  Located<std::vector<double>> velocity;  ///< m/s, of a tow in uniform motion; empty: at rest
  std::optional<ContinuationDeck> continuation;
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
