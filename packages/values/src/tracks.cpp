#include "hawser/values/tracks.hpp"

namespace hawser {

Tracks make_tracks(const std::vector<TrackDeck>& decks, Diagnostics& diagnostics) {
  Tracks tracks;
  for (const TrackDeck& deck : decks)
    if (!tracks.emplace(deck.name.value, std::make_shared<Track>(deck)).second)
      diagnostics.error(deck.name.location, "there are two tracks '" + deck.name.value + "'");
  return tracks;
}

std::shared_ptr<const Track> find_track(const Tracks& tracks, const Located<std::string>& name,
                                        Diagnostics& diagnostics) {
  const auto found = tracks.find(name.value);
  if (found != tracks.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& entry : tracks)
    names.push_back(entry.first);
  diagnostics.error(name.location, "the deck has no track '" + name.value + "'; it has " +
                                       listed(names) + did_you_mean(name.value, names));
  return nullptr;
}

}  // namespace hawser
