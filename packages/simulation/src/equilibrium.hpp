#pragma once
// The steady state at which a run begins.
//
// Newton's method on the steady equations (decision 0010) is tried first. Where it finds nothing,
// as for a cable that lies slack and has no stiffness against its weight, the state is relaxed:
// steps of implicit Euler that end at the time of the start, so that the conditions are those of
// the start throughout, and that structures begin at rest. A structure then goes down its energy
// with its own mass as the metric, m (d - d_k)/dt^2 + internal = external forces, and a flow passes
// through its transient: pseudo-transient continuation (Kelley & Keyes, SIAM J. Numer. Anal. 35
// (1998) 508-523) with the inertia that the modules themselves have. The length of the steps
// follows from counts of Newton's iterations alone, so the same start twice is the same to the last
// bit.
#include <array>
#include <functional>
#include <string>

#include "hawser/simulation/stepper.hpp"
#include "hawser/solve/solver_deck.hpp"
#include "src/system.hpp"

namespace hawser {

struct EquilibriumOptions {
  LinearOptions linear;
  NonlinearOptions newton;        ///< of the steady solves
  double relaxation_step = 1;     ///< s, the first one
  std::array<double, 3> drift{};  ///< m/s, with which all of the state moves
  bool relaxes = true;            ///< else Newton's method alone
};

/// From the system's state to the steady one under the conditions of its time. Every solve is told.
/// SolveError when there is none to be had. Collective.
State find_equilibrium(System& system, const EquilibriumOptions& options,
                       const std::function<void(const StartSolve&)>& tell);

}  // namespace hawser
