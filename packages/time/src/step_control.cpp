#include "hawser/time/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {
constexpr double slack = 1e-6;         // of a step: times that differ by less are the same
constexpr double greatest_growth = 2;  // from step to step
}  // namespace

StepControl::StepControl(const StepOptions& options, std::vector<double> events)
    : options_(options), events_(std::move(events)), step_(options.step) {
  events_.push_back(options.end);
  std::sort(events_.begin(), events_.end());
}

bool StepControl::finished(double time) const {
  return time >= options_.end - slack * options_.step;
}

double StepControl::next(double time, double previous) const {
  const double wanted = previous > 0 ? std::min(step_, greatest_growth * previous) : step_;
  const auto event = std::upper_bound(events_.begin(), events_.end(), time + slack * options_.step);
  if (event == events_.end()) return wanted;
  const double left = *event - time;
  const double steps = std::max(1.0, std::ceil(left / wanted - slack));
  // Whole steps but for round-off stay whole: runs with another end or with other events take the
  // very same steps up to there.
  const bool whole = std::abs(left - steps * wanted) <= slack * wanted;
  return whole || steps > 2 ? wanted : left / steps;
}

bool StepControl::is_too_inaccurate(const StepOutcome& outcome) const {
  return options_.targets && options_.targets->error > 0 &&
         outcome.error.value_or(0) > options_.targets->error;
}

/// By which the next step may be longer.
double StepControl::factor(const StepOutcome& outcome) const {
  constexpr double safety = 0.9;
  double result = greatest_growth;
  const StepTargets& targets = *options_.targets;
  if (targets.error > 0 && !outcome.error) result = 1;
  if (targets.error > 0 && outcome.error.value_or(0) > 0)
    result = std::min(
        result, safety * std::pow(targets.error / *outcome.error, 1.0 / (options_.order + 1)));
  if (targets.newton_iterations > 0 && outcome.newton_iterations > 0)
    result = std::min(result, static_cast<double>(targets.newton_iterations) /
                                  static_cast<double>(outcome.newton_iterations));
  return result;
}

void StepControl::accepted(double attempted, const StepOutcome& outcome) {
  if (options_.targets) {
    const double wanted = std::max(0.5, factor(outcome));
    // A little longer or shorter is not worth a new matrix.
    if (wanted >= 0.85 && wanted < 1.2) return;
    step_ = std::max(options_.least, attempted * wanted);
    if (options_.targets->longest > 0) step_ = std::min(step_, options_.targets->longest);
    return;
  }
  if (step_ >= options_.step || ++successes_ < options_.grow_after) return;
  step_ = std::min(options_.step, 2 * step_);
  successes_ = 0;
}

bool StepControl::rejected(double attempted, const StepOutcome& outcome) {
  successes_ = 0;
  const double cut = is_too_inaccurate(outcome) ? std::clamp(factor(outcome), 0.2, 0.8) : 0.5;
  if (attempted * cut < options_.least) return false;
  step_ = attempted * cut;
  return true;
}

}  // namespace hawser
