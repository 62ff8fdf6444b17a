#pragma once
// How long the next step is: cut after a rejection, grown again after successes or steered by the
// local error or by Newton's effort, never past an event. Decisions rest on counters and on the
// solution, never on measured time, so that the same run twice is the same to the last bit.
#include <optional>
#include <vector>

namespace hawser {

/// What steers the length; with both, the shorter step is taken.
struct StepTargets {
  double error = 0;           ///< local error of a step, relative; 0: not looked at
  int newton_iterations = 0;  ///< per step; 0: not looked at
  double longest = 0;         ///< s; 0: no limit
};

/// What a step has cost and how good it was.
struct StepOutcome {
  std::optional<double> error{};  ///< TimeIntegrator::local_error
  int newton_iterations = 0;
};

struct StepOptions {
  double step = 1;     ///< s, the wanted length, or the first one when it is steered
  double least = 0;    ///< s, below which the run gives up
  double end = 1;      ///< s
  int grow_after = 4;  ///< accepted steps in a row before a cut step is doubled
  std::optional<StepTargets> targets;
  int order = 2;  ///< of the time scheme: the local error goes with step^(order + 1)
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
  void accepted(double attempted, const StepOutcome& outcome);
  bool is_too_inaccurate(const StepOutcome& outcome) const;
  /// A shorter step from now on: half of the attempted length, or what its error asks for. False
  /// when that would be below the least.
  bool rejected(double attempted, const StepOutcome& outcome = {});

  /// All that its further decisions depend on; part of a checkpoint.
  double step() const { return step_; }
  int successes() const { return successes_; }
  void resume(double step, int successes) { step_ = step, successes_ = successes; }

 private:
  double factor(const StepOutcome& outcome) const;

  StepOptions options_;
  std::vector<double> events_;
  double step_;
  int successes_ = 0;
};

}  // namespace hawser
