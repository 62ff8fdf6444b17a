#include "hawser/base/communicator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

TEST(Communicator, ThrowsOnAllRanksWhatOneRankThrew) {
  const Communicator all;
  const int last = all.size() - 1;
  try {
    all.together([&] {
      if (all.rank() == last) throw MeshError("cell 7 is inside out");
    });
    FAIL() << "nothing thrown";
  } catch (const MeshError& error) {
    EXPECT_STREQ(error.what(), "cell 7 is inside out");
  }
}

TEST(Communicator, TheLowestRankSpeaks) {
  const Communicator all;
  EXPECT_THAT([&] { all.together([&] { throw OutputError(std::to_string(all.rank())); }); },
              testing::ThrowsMessage<OutputError>("0"));
}

TEST(Communicator, RootsErrorIsEveryones) {
  const Communicator all;
  EXPECT_THROW(all.on_root([] { throw DeckError("no such file"); }), DeckError);
  EXPECT_NO_THROW(all.on_root([] {}));
}

TEST(Communicator, ReducesAndBroadcasts) {
  const Communicator all;
  EXPECT_EQ(all.sum(1LL), all.size());
  EXPECT_EQ(all.max(double(all.rank())), all.size() - 1);
  EXPECT_TRUE(all.any(all.is_root()));
  EXPECT_EQ(all.broadcast(all.is_root() ? "deck" : ""), "deck");
}

// As more than 2 GiB would have to be.
TEST(Communicator, SendsInPieces) {
  const Communicator all;
  const std::vector<char> bytes = {'h', 'a', 'w', 's', 'e', 'r', 's'};
  for (const std::size_t piece : {1, 3, 7, 100}) {
    if (all.is_root())
      for (int rank = 1; rank < all.size(); ++rank)
        all.send(bytes, rank, piece);
    else
      EXPECT_EQ(all.receive(0, piece), bytes);
  }
}

}  // namespace
}  // namespace hawser
