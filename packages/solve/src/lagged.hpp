#pragma once
// Iteration on the residual alone, with the Jacobian and factor that an earlier solve left behind.
#include "newton.hpp"

namespace hawser {

class Lagged {
 public:
  explicit Lagged(Newton& newton) : newton_(newton) {}

  /// False: not wanted, or no success; x is then the best iterate seen.
  bool solve(TpetraVector& x);

  void forget() { stale_ = true; }  ///< the next solve starts with a new Jacobian

 private:
  void renew(const TpetraVector& x);
  bool iterate(TpetraVector& x);

  Newton& newton_;
  bool stale_ = true;  ///< the Jacobian at hand, if any, is to be renewed
  int spent_ = 0;      ///< iterations since the renewal, and what that cost in such
  int solves_ = 0;     ///< since the renewal
};

}  // namespace hawser
