#include "hawser/time/step_control.hpp"

#include <algorithm>

namespace hawser {
namespace {
constexpr double slack = 1e-9;  // of a step: times that differ by less are the same
}

StepControl::StepControl(const StepOptions& options, std::vector<double> events)
    : options_(options), events_(std::move(events)), step_(options.step) {
  events_.push_back(options.end);
  std::sort(events_.begin(), events_.end());
}

bool StepControl::finished(double time) const {
  return time >= options_.end - slack * options_.step;
}

double StepControl::next(double time) const {
  const auto event = std::upper_bound(events_.begin(), events_.end(), time + slack * step_);
  const double left = event == events_.end() ? step_ : *event - time;
  // A remainder that is a whole step but for round-off is one: runs with another end or with other
  // events take the very same steps up to there.
  return left < step_ * (1 - slack) ? left : step_;
}

void StepControl::accepted() {
  if (step_ >= options_.step || ++successes_ < options_.grow_after) return;
  step_ = std::min(options_.step, 2 * step_);
  successes_ = 0;
}

bool StepControl::rejected() {
  successes_ = 0;
  if (step_ / 2 < options_.least) return false;
  step_ /= 2;
  return true;
}

}  // namespace hawser
