#pragma once
// A deck whose cells or steps are 2^level times smaller.
#include "hawser/deck/deck.hpp"
#include "hawser/simulation/simulation.hpp"

namespace hawser {

/// Changes sizes in <mesh> and the step in <time>. Takes out <expect>, which is about the deck as
/// it stands. DeckError when the mesh comes from a file or a steady solve has no step.
void refine(DeckNode& deck, const RefinedBy& refined);

}  // namespace hawser
