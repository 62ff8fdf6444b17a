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
  /// Length of the step from `time`, after one of length `previous` (s; 0 at the start): ends on an
  /// event or the end, but for round-off. What remains to an event is split evenly and a step is at
  /// most twice the previous one: a rate found over a sliver would be noise in the next long step.
  double next(double time, double previous) const;
  void accepted();
  /// Half of the attempted length from now on; false when that would be below the least.
  bool rejected(double attempted);

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
