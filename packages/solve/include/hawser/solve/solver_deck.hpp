#pragma once
// What a deck says of <solver>.
#include "hawser/deck/spec.hpp"
#include "hawser/solve/nonlinear_driver.hpp"

namespace hawser {

struct SolverDeck {
  LinearOptions linear;
  NonlinearOptions newton;
  static Spec<SolverDeck> spec();
};

}  // namespace hawser
