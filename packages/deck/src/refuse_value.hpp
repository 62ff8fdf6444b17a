#pragma once
#include <cmath>
#include <string>

#include "hawser/base/error.hpp"
#include "hawser/deck/expression.hpp"
#include "hawser/deck/value.hpp"

namespace hawser {

/// `number`, which is `what`, is not finite. `more` goes on after the place.
template <class Formula>
[[noreturn]] void refuse_value(double number, const std::string& what, const Formula& formula,
                               const SpaceTime& at, const std::string& more) {
  std::string where = "x = " + write_value(at.x) + ", y = " + write_value(at.y);
  if (at.z != 0) where += ", z = " + write_value(at.z);
  throw SolveError(formula.location().text() + ": the " + what + " '" + formula.text() + "' is " +
                   (std::isnan(number) ? "not a number" : "infinite") + " at " + where +
                   " m, t = " + write_value(at.t) + " s" + more);
}

}  // namespace hawser
