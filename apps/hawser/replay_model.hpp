#pragma once
// A replay's deck as a model: positions of the receivers at the shots, for values of its
// parameters.
#include "hawser/replay/comparison.hpp"
#include "hawser/simulation/case.hpp"

namespace hawser::program {

struct ModelRun {
  Positions positions{};
  double cpu_seconds = 0;  ///< of this rank, from the deck to the last step
  int steps = 0;
};

/// Runs the deck with these changes; between two steps positions are interpolated linearly, as in
/// receivers.csv. Collective; any Error on all ranks.
ModelRun run_model(const Environment& environment, const std::string& deck,
                   const std::vector<DeckChange>& changes, const MeasuredLine& line);

}  // namespace hawser::program
