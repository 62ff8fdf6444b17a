#pragma once
// Iteration on the residual alone, with the Jacobian and factor that an earlier solve left behind.
#include "newton.hpp"

namespace hawser {

class Lagged {
 public:
  explicit Lagged(Newton& newton) : newton_(newton) {}

  /// False: not wanted, nothing to start from, or no success; x is then the best iterate seen.
  bool solve(TpetraVector& x);

  void forget() { stale_ = true; }  ///< the next solve starts with a new Jacobian

 private:
  bool iterate(TpetraVector& x);

  Newton& newton_;
  bool stale_ = true;  ///< the Jacobian at hand, if any, is not worth trying
};

}  // namespace hawser
