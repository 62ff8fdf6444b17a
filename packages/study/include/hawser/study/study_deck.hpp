#pragma once
// A study: sweeps over decks, each of a base deck and what differs from case to case.
#include <optional>
#include <string>
#include <vector>

#include "hawser/deck/spec.hpp"

namespace hawser {

/// The same for all cases of a sweep, or of one case.
struct SetDeck {
  Located<std::string> path, value;
  static Spec<SetDeck> spec();
};

/// A value that goes through a list or a range.
struct VaryDeck {
  Located<std::string> path;
  std::optional<Located<std::string>> values;
  std::optional<double> from, to;
  std::optional<int> count;
  bool logarithmic = false;
  Location location;
  static Spec<VaryDeck> spec();
  /// The texts to set, in order.
  std::vector<std::string> texts() const;
};

struct CaseDeck {
  Located<std::string> name;
  std::string title;
  std::vector<SetDeck> sets;
  static Spec<CaseDeck> spec();
};

struct SweepDeck {
  Located<std::string> name, deck;
  std::string meaning;
  bool together = false;  ///< all values advance at once, instead of every combination
  std::vector<SetDeck> sets;
  std::vector<VaryDeck> varies;
  std::vector<CaseDeck> cases;
  Location location;
  static Spec<SweepDeck> spec();
};

struct StudyDeck {
  std::string title;
  std::string report = "table";
  int ranks = 1;
  std::vector<SweepDeck> sweeps;
  static Spec<StudyDeck> spec();
};

}  // namespace hawser
