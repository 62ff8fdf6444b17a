#pragma once
#include <vector>

#include "hawser/deck/read_deck.hpp"
#include "hawser/simulation/run_deck.hpp"

namespace hawser {

/// What to change in a deck so that its cells, its steps or both are 2^level times smaller. Boxes
/// are refined by cutting their triangles, so that meshes are nested. DeckError when the mesh comes
/// from a file or a steady solve has no step.
std::vector<DeckChange> refinement(const RunDeck& deck, Refinement what, int level);

}  // namespace hawser
