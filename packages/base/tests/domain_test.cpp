#include "hawser/base/domain.hpp"

#include <gtest/gtest.h>

namespace hawser {
namespace {

TEST(Domain, SaysWhatItIs) {
  const Domain both(std::vector<std::string>{"near", "far"});
  EXPECT_EQ(Domain("water").text(), "water");
  EXPECT_EQ(both.text(), "near far");
  EXPECT_EQ(Domain::facets("outflow").text(), "facets of outflow");
  EXPECT_EQ(Domain::patches(both).text(), "patches of near far");
  EXPECT_EQ(Domain::ends("cable", "tail").text(), "cable at tail");
}

TEST(Domain, IsToldApartByRegionsKindAndPoint) {
  EXPECT_EQ(Domain("water"), Domain(std::string("water")));
  EXPECT_FALSE(Domain("cable") == Domain::patches("cable"));
  EXPECT_FALSE(Domain::ends("cable", "tail") == Domain::ends("cable", "middle"));
  EXPECT_TRUE(Domain("water").is_region());
  EXPECT_FALSE(Domain::facets("wall").is_region());
  EXPECT_FALSE(Domain(std::vector<std::string>{"near", "far"}).is_region());
}

}  // namespace
}  // namespace hawser
