#pragma once
#include <optional>

#include "hawser/deck/spec.hpp"
#include "hawser/time/step_control.hpp"
#include "hawser/time/time_scheme.hpp"

namespace hawser {

/// What a deck says of <time>.
struct TimeDeck : StepOptions {
  TimeScheme::Method method = TimeScheme::Method::newmark;
  std::optional<double> beta, gamma, rho_infinity, theta;
  bool euler_start = true;
  double energy_growth = 10;  ///< EnergyLedger::grows; 0: not looked at
  Location location;
  bool steady() const { return method == TimeScheme::Method::steady; }
  /// One steady solve: there is no shorter step to try; load steps have one.
  bool single_solve() const { return steady() && step == end; }
  TimeScheme scheme() const;
  static Spec<TimeDeck> spec();
};

}  // namespace hawser
