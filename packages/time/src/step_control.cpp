#include "hawser/time/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {
constexpr double slack = 1e-6;  // of a step: times that differ by less are the same
}

StepControl::StepControl(const StepOptions& options, std::vector<double> events)
    : options_(options), events_(std::move(events)), step_(options.step) {
  events_.push_back(options.end);
  std::sort(events_.begin(), events_.end());
}

bool StepControl::finished(double time) const {
  return time >= options_.end - slack * options_.step;
}

double StepControl::next(double time, double previous) const {
  const double wanted = previous > 0 ? std::min(step_, 2 * previous) : step_;
  const auto event = std::upper_bound(events_.begin(), events_.end(), time + slack * options_.step);
  if (event == events_.end()) return wanted;
  const double left = *event - time;
  const double steps = std::max(1.0, std::ceil(left / wanted - slack));
  // Whole steps but for round-off stay whole: runs with another end or with other events take the
  // very same steps up to there.
  const bool whole = std::abs(left - steps * wanted) <= slack * wanted;
  return whole || steps > 2 ? wanted : left / steps;
}

void StepControl::accepted() {
  if (step_ >= options_.step || ++successes_ < options_.grow_after) return;
  step_ = std::min(options_.step, 2 * step_);
  successes_ = 0;
}

bool StepControl::rejected(double attempted) {
  successes_ = 0;
  if (attempted / 2 < options_.least) return false;
  step_ = attempted / 2;
  return true;
}

}  // namespace hawser
