#pragma once
// A deck's tracks by name.
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hawser/values/track.hpp"

namespace hawser {

using Tracks = std::map<std::string, std::shared_ptr<const Track>>;

/// A name given twice is a fault.
Tracks make_tracks(const std::vector<TrackDeck>& decks, Diagnostics& diagnostics);

/// Null, and an error, when there is no such track.
std::shared_ptr<const Track> find_track(const Tracks& tracks, const Located<std::string>& name,
                                        Diagnostics& diagnostics);

}  // namespace hawser
