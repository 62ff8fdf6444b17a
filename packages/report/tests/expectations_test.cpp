#include "hawser/report/expectations.hpp"

#include <gtest/gtest.h>

namespace hawser {
namespace {

ExpectDeck expect(const std::string& quantity, double value, double within) {
  return {{quantity, {"d.xml", 3, 1}}, value, within, "theory"};
}

TEST(Expectations, HoldUpToTheirBoundAndFailWithoutAQuantity) {
  Summary summary;
  summary.set("force_n", 10.5);
  const auto judged =
      judge({expect("force_n", 10, 0.5), expect("force_n", 10, 0.4), expect("farce_n", 10, 100)},
            summary);
  ASSERT_EQ(judged.size(), 3U);
  EXPECT_TRUE(judged[0].holds);
  EXPECT_FALSE(judged[1].holds);
  EXPECT_EQ(judged[1].got, 10.5);
  EXPECT_FALSE(judged[2].holds);
  EXPECT_FALSE(judged[2].got.has_value());
}

TEST(Expectations, AreCountedInTheSummary) {
  Summary summary;
  summary.set("force_n", 10.5);
  add_judgements(judge({expect("force_n", 10, 0.4), expect("none", 1, 1)}, summary), summary);
  EXPECT_EQ(summary.number("expectations_failed"), 2);
  EXPECT_NE(summary.json().find("never evaluated"), std::string::npos);
  EXPECT_NE(summary.json().find("d.xml:3:1"), std::string::npos);
}

TEST(Expectations, LeaveNoTraceWhereThereAreNone) {
  Summary summary;
  add_judgements({}, summary);
  EXPECT_EQ(summary.json(), Summary().json());
}

}  // namespace
}  // namespace hawser
