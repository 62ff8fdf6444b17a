#include "hawser/base/duration.hpp"

#include <gtest/gtest.h>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

TEST(Duration, IsReadAsPeopleWriteIt) {
  EXPECT_EQ(read_duration("5h50m"), 5 * 3600 + 50 * 60);
  EXPECT_EQ(read_duration("1d12h"), 36 * 3600);
  EXPECT_EQ(read_duration("1d2h3m4s"), 86400 + 7200 + 180 + 4);
  EXPECT_EQ(read_duration("90m"), 5400);
  EXPECT_EQ(read_duration("1.5h"), 5400);
  EXPECT_EQ(read_duration("45"), 45);
}

TEST(Duration, IsRefusedWhereItIsNone) {
  for (const char* text : {"", "0", "0m", "h", "5x", "5h50", "50m5h", "5h5h", "-5m", "1e3", "5:50",
                           "1..5h", ".", "nan"})
    EXPECT_THROW(read_duration(text), Error) << text;
}

}  // namespace
}  // namespace hawser
