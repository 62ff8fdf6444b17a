#pragma once
// One deck on ever finer meshes or with ever shorter steps: at which order do its errors vanish?
#include <optional>
#include <string>

#include "hawser/output/summary.hpp"
#include "hawser/report/verification_deck.hpp"
#include "hawser/simulation/run.hpp"

namespace hawser {

struct ConvergenceOptions {
  RunOptions run;                      ///< `output` receives a folder per level
  std::vector<DeckChange> changes{};   ///< of the deck
  std::optional<Refinement> refine{};  ///< instead of the deck's
  std::optional<int> levels{};         ///< likewise
};

/// Runs all levels one after the other, prints a table, writes converge.json and converge.csv, and
/// returns what converge.json says; "orders_failed" counts the <order> elements that do not hold.
/// Collective; any Error on all ranks.
Summary converge(const Environment& environment, const std::string& deck_file,
                 const ConvergenceOptions& options);

}  // namespace hawser
