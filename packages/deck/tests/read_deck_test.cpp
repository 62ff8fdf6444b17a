#include <gtest/gtest.h>

#include <fstream>

#include "hawser/base/error.hpp"
#include "hawser/deck/deck.hpp"

namespace hawser {
namespace {

std::string message_of(const Communicator& world, const std::string& file) {
  try {
    Diagnostics diagnostics;
    read_deck(world, file, diagnostics);
  } catch (const DeckError& error) {
    return error.what();
  }
  return "";
}

TEST(ReadDeck, EveryRankSeesTheSameDeck) {
  const Communicator world;
  world.on_root(
      [] { std::ofstream("small.xml") << "<hawser>\n  <mesh file='m.msh'/>\n</hawser>\n"; });
  Diagnostics diagnostics;
  const Deck deck = read_deck(world, "small.xml", diagnostics);
  EXPECT_TRUE(diagnostics.ok());
  EXPECT_EQ(deck.root.tag, "hawser");
  ASSERT_EQ(deck.root.children.size(), 1u);
  EXPECT_EQ(deck.root.children[0].attributes[0].value, "m.msh");
  EXPECT_EQ(deck.root.children[0].attributes[0].location.text(), "small.xml:2:9");
}

TEST(ReadDeck, AFileThatCannotBeReadIsADeckErrorOnEveryRank) {
  const Communicator world;
  EXPECT_EQ(message_of(world, "absent.xml"), "absent.xml: the deck cannot be read");
  EXPECT_EQ(message_of(world, "."), ".: the deck cannot be read");
}

TEST(ReadDeck, MalformedXmlIsADeckErrorOnEveryRank) {
  const Communicator world;
  world.on_root([] { std::ofstream("bad.xml") << "<hawser>\n"; });
  EXPECT_EQ(message_of(world, "bad.xml"),
            "bad.xml:2:1: the deck ends before all its elements are closed: <hawser> of line 1");
}

}  // namespace
}  // namespace hawser
