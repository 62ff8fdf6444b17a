#pragma once
// The deck that is made of a measured line, and the tables that it names: an ordinary one, to go on
// with.
#include "hawser/replay/measured_line.hpp"

namespace hawser {

/// A parameter of that deck.
struct ReplayParameter {
  std::string name, unit, meaning;
  std::string value;  ///< as decks have it
  bool may_be_fitted = false;
  double change = 0;           ///< SI, by which a difference is taken
  double least = 0, most = 0;  ///< SI, what a fit may find
};

/// ct, cn, tail_drag_area, current_east, ... with the usual values.
std::vector<ReplayParameter> replay_parameters();

struct ReplayDeckOptions {
  int segments = 80;
  double step = 20;       ///< s
  std::string made_by{};  ///< the command line, for the deck's head
};

/// Beside tables head.csv and shape.csv.
std::string replay_deck(const MeasuredLine& line, const std::vector<ReplayParameter>& parameters,
                        const ReplayDeckOptions& options);
std::string head_csv(const MeasuredLine& line);
std::string shape_csv(const MeasuredLine& line);

}  // namespace hawser
