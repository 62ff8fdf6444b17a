#pragma once
// Does a run report what its deck expects?
#include <optional>
#include <vector>

#include "hawser/output/summary.hpp"
#include "hawser/report/output_deck.hpp"

namespace hawser {

struct Judgement {
  ExpectDeck expect;
  std::optional<double> got;  ///< none when the run reports no such quantity; then it fails
  bool holds = false;
};

/// Expectations of quantities that are none of those, before a run.
void check_expectations(const std::vector<ExpectDeck>& expectations,
                        const std::vector<std::string>& quantities, Diagnostics& diagnostics);

std::vector<Judgement> judge(const std::vector<ExpectDeck>& expectations, const Summary& summary);

/// Adds "expectations" and "expectations_failed", unless nothing is expected.
void add_judgements(const std::vector<Judgement>& judgements, Summary& summary);

}  // namespace hawser
