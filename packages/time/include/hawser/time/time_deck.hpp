#pragma once
#include <optional>

#include "hawser/deck/spec.hpp"
#include "hawser/time/step_control.hpp"
#include "hawser/time/time_scheme.hpp"

namespace hawser {

/// What a deck says of <time>.
struct TimeDeck : StepOptions {
  TimeScheme::Method method = TimeScheme::Method::newmark;
  std::optional<double> beta, gamma, rho_infinity;
  bool euler_start = true;
  Location location;
  bool steady() const { return method == TimeScheme::Method::steady; }
  TimeScheme scheme() const;
  static Spec<TimeDeck> spec();
};

}  // namespace hawser
