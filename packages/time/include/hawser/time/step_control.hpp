#pragma once
// How long the next step is: cut after a rejection, grown again after successes, never past an
// event. Decisions rest on counters only, so that the same run twice is the same to the last bit.
#include <vector>

namespace hawser {

struct StepOptions {
  double step = 1;     ///< s, the wanted length
  double least = 0;    ///< s, below which the run gives up
  double end = 1;      ///< s
  int grow_after = 4;  ///< accepted steps in a row before a cut step is doubled
};

class StepControl {
 public:
  /// `events` are times that a step must hit, such as the edges of conditions' time windows.
  StepControl(const StepOptions& options, std::vector<double> events);

  bool finished(double time) const;
  /// Length of the step from `time`; ends on an event or the end, but for round-off.
  double next(double time) const;
  void accepted();
  /// Halves the step; false when that would be below the least.
  bool rejected();

  /// All that its further decisions depend on; part of a checkpoint.
  double step() const { return step_; }
  int successes() const { return successes_; }
  void resume(double step, int successes) { step_ = step, successes_ = successes; }

 private:
  StepOptions options_;
  std::vector<double> events_;
  double step_;
  int successes_ = 0;
};

}  // namespace hawser
