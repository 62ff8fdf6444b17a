#include "hawser/values/tracks.hpp"

#include <gtest/gtest.h>

namespace hawser {
namespace {

TrackDeck named(const std::string& name, double speed) {
  TrackDeck deck;
  deck.name = {name, {"d.xml", 2, 3}};
  deck.speed = speed;
  deck.way_points = {{{0, 0}}, {{0, 100}}};
  return deck;
}

TEST(Tracks, AreFoundByName) {
  Diagnostics diagnostics;
  const Tracks tracks = make_tracks({named("out", 1), named("back", 2)}, diagnostics);
  EXPECT_EQ(find_track(tracks, {"back", {}}, diagnostics)->speed(1e4), 2);
  EXPECT_TRUE(diagnostics.ok());
  EXPECT_EQ(find_track(tracks, {"bakc", {"d.xml", 5, 1}}, diagnostics), nullptr);
  EXPECT_EQ(diagnostics.error_text(),
            "d.xml:5:1: the deck has no track 'bakc'; it has back, out; did you mean 'back'?");
}

TEST(Tracks, HaveANameEach) {
  Diagnostics diagnostics;
  make_tracks({named("out", 1), named("out", 2)}, diagnostics);
  EXPECT_EQ(diagnostics.error_text(), "d.xml:2:3: there are two tracks 'out'");
}

}  // namespace
}  // namespace hawser
