#pragma once
// Natural-parameter continuation: steady states of one deck, along the values of a parameter.
//
// Every state starts from the last one or, when there are two, from their secant. A step that finds
// nothing is halved, one that takes few iterations of Newton's method is followed by one of twice
// the length; counts alone decide. Each value has a system of its own on the same mesh file, whose
// rows are the same on the same ranks; the last one, at the deck's own value, is the run's.
// (Allgower & Georg, Introduction to Numerical Continuation Methods, SIAM 2003, chapter 2.)
#include "src/equilibrium.hpp"

namespace hawser {

/// As find_equilibrium(). `system` is that of the case on that mesh.
State continue_equilibrium(const Case& run_case, const std::string& mesh_file, System& system,
                           const EquilibriumOptions& options,
                           const std::function<void(const StartSolve&)>& tell);

}  // namespace hawser
