#pragma once
// All values and rates at one time, for every local row (owned and ghost).
#include <array>
#include <vector>

#include "hawser/base/types.hpp"

namespace hawser {

struct State {
  double time = 0;  ///< s
  double step = 0;  ///< s; the step that led here; infinite in a steady solve
  /// s, from the instant of the last accepted equations to `time`; infinite in a steady solve.
  double elapsed = 0;
  double share = 1;  ///< of the step after which it stands: 1 at the end
  /// m/s: a steady solve finds structures that move along with this velocity as a whole.
  std::array<double, 3> drift{};
  bool bounds_energy = false;  ///< forces do at least the work that their energy gains in the step
  std::vector<double> value;   ///< per local row
  std::vector<double> rate;    ///< d/dt at fixed reference point; 0 for fields without a rate
  std::vector<double> accepted;  ///< values at the last accepted step

  // How a rate follows from the unknowns at the same node: d rate / d value, and for a structure's
  // displacement, whose rate is the velocity, d rate / d velocity.
  std::vector<double> rate_slope;
  std::vector<double> rate_partner;
};

}  // namespace hawser
