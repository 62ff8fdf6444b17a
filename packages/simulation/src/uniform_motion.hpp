#pragma once
// <equilibrium velocity>: a start at which lines move along as a whole.
#include <array>

#include "hawser/simulation/run_deck.hpp"
#include "src/system.hpp"

namespace hawser {

/// What of a deck that asks for it does not fit together.
void check_uniform_motion(const RunDeck& deck, Diagnostics& diagnostics);

/// m/s; zero where the deck does not ask for it. DeckError where water is in the mesh, or a node is
/// prescribed to move otherwise. Collective.
std::array<double, 3> drift_of_start(const System& system, const RunDeck& deck);

}  // namespace hawser
