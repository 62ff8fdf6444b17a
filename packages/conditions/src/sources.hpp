#pragma once
// The values that a condition asks for: formulas, a table's, or those of a track.
#include <memory>

#include "hawser/base/communicator.hpp"
#include "hawser/conditions/conditions_deck.hpp"
#include "hawser/values/tracks.hpp"

namespace hawser {

/// Never null: after a fault it is one that gives zeros. Reads a table's file on rank 0.
/// Collective.
std::shared_ptr<const ValueSource> make_source(const Communicator& communicator,
                                               const ConditionDeck& deck, const Tracks& tracks,
                                               Diagnostics& diagnostics);

/// Where the deck says which values: of the attribute value, table or track.
const Location& source_location(const ConditionDeck& deck);

}  // namespace hawser
