#pragma once
// The values that a condition asks for: formulas, a table's, or those of a track.
#include <map>
#include <memory>
#include <string>

#include "hawser/simulation/deck_parameters.hpp"
#include "hawser/values/value_source.hpp"

namespace hawser {

using Tracks = std::map<std::string, std::shared_ptr<const Track>>;

/// A name given twice is a fault.
Tracks make_tracks(const std::vector<TrackDeck>& decks, Diagnostics& diagnostics);

/// Null, and an error, when there is no such track.
std::shared_ptr<const Track> find_track(const Tracks& tracks, const Located<std::string>& name,
                                        Diagnostics& diagnostics);

/// Never null: after a fault it is one that gives zeros. Reads a table's file on rank 0.
/// Collective.
std::shared_ptr<const ValueSource> make_source(const Communicator& communicator,
                                               const ConditionDeck& deck, const Tracks& tracks,
                                               Diagnostics& diagnostics);

/// Where the deck says which values: of the attribute value, table or track.
const Location& source_location(const ConditionDeck& deck);

}  // namespace hawser
