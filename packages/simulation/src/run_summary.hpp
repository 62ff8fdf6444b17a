#pragma once
// What a run amounts to: the last step's quantities, and how they came about.
#include <string>
#include <vector>

#include "hawser/output/checkpoint.hpp"
#include "hawser/output/summary.hpp"
#include "src/system.hpp"

namespace hawser {

class RunSummary {
 public:
  void add(const StepFigures& figures);
  void rejected() { ++rejected_; }

  /// What a restarted run goes on with.
  void save(CheckpointHeader& header) const;
  void resume(const CheckpointHeader& header);

  Summary summary(const System& system, const RunDeck& deck) const;

 private:
  long long steps_ = 0, rejected_ = 0, newton_ = 0, linear_ = 0;
  double least_quality_ = 1;
  double courant_ = 0;
  StepFigures last_;
  std::vector<std::pair<double, double>> end_errors_;  // time, error
};

/// Adds "expectations" to the summary: how many hold, and each that does not. A quantity that the
/// run does not report fails, too.
void check_expectations(const RunDeck& deck, Summary& summary);

}  // namespace hawser
