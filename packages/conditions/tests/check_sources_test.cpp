// What a table lacks for a run is told before the run's first step.
#include <gmock/gmock.h>

#include <fstream>
#include <limits>

#include "hawser/base/error.hpp"
#include "sample_conditions.hpp"

namespace hawser {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Of a run from `start` to `end` s in steps of 1 s; "" when there is nothing to say.
struct Run {
  double start = 0, end = 10;
  bool steady = false, jump_is_meant = false;
};
std::string said(const std::string& attributes, const std::string& table, const Run& run,
                 const TableDeck& deck = {}) {
  NamedSources named;
  named.tables.push_back(deck);
  named.tables[0].name.value = "data";
  named.tables[0].file.value = "data.csv";
  std::ofstream("data.csv") << table;
  SampleConditions sample("<prescribe " + attributes + " table=\"data\"/>", named);
  EXPECT_EQ(sample.diagnostics.error_text(), "");
  sample.state.time = run.start;
  sample.state.step = run.steady ? std::numeric_limits<double>::infinity() : 1;
  try {
    sample.conditions->check_sources(sample.state, 1, run.end, run.jump_is_meant);
  } catch (const DeckError& error) {
    EXPECT_THAT(error.what(), StartsWith("d.xml:1:"));
    return error.what();
  }
  return "";
}

const std::string current = "time_s,u_m_per_s,v_m_per_s\n0,0,1\n10,0,1\n";
const std::string flow = R"(field="velocity" on="water")";

struct Window {
  std::string attributes;
  Run run;
  std::string words;  // "" where the table is long enough
};
class Windows : public testing::TestWithParam<Window> {};
TEST_P(Windows, OfTheRunMustBeThoseOfTheTable) {
  const Window& given = GetParam();
  const std::string text = said(flow + given.attributes, current, given.run);
  if (given.words.empty())
    EXPECT_EQ(text, "");
  else
    EXPECT_THAT(text, HasSubstr("the table reaches from t = 0 s to t = 10 s, and the run needs it "
                                "from t = " +
                                given.words));
}
INSTANTIATE_TEST_SUITE_P(
    CheckSources, Windows,
    testing::Values(Window{"", {0, 10}, ""}, Window{"", {0, 10 * (1 + 1e-12)}, ""},
                    Window{"", {0, 10.1}, "0 s to t = 10.1 s"},
                    Window{"", {-1, 10}, "-1 s to t = 10 s"}, Window{"", {5, 10}, ""},
                    Window{"", {5, 20}, "5 s to t = 20 s"}, Window{R"( until="8")", {0, 20}, ""},
                    Window{R"( until="0 s")", {0, 20}, ""},
                    Window{R"( from="15")", {0, 20}, "15 s to t = 20 s"},
                    Window{R"( from="25")", {0, 20}, ""}, Window{R"( until="-5")", {0, 20}, ""},
                    Window{R"( from="2")", {-5, 9}, ""}, Window{"", {0, 1, true}, ""},
                    Window{"", {-1, 5, true}, ""}, Window{"", {0, 12, true}, "1 s to t = 12 s"}));

TEST(CheckSources, PlacesMustBeThoseOfTheNodes) {
  const std::string narrow = "x_m,u_m_per_s,v_m_per_s\n0,0,1\n3,0,1\n";
  EXPECT_THAT(
      said(flow, narrow, {}),
      HasSubstr("the table reaches from x = 0 m to x = 3 m, and the nodes of this condition from "
                "x = 0 m to x = 4 m"));
  EXPECT_EQ(said(flow, "x_m,u_m_per_s,v_m_per_s\n0,0,1\n4,0,1\n", {}), "");
}

struct Start {
  std::string first, last;
  double distance;  // m, that is told; 0: none
};
class Starts : public testing::TestWithParam<Start> {};
TEST_P(Starts, OfATrackMustBeWhereThePointIs) {
  const Start& given = GetParam();
  const std::string track =
      "time_s,displacement_x_m,displacement_y_m\n0," + given.first + "\n10," + given.last + "\n";
  const std::string tail = R"(field="displacement" on="tail")";
  const std::string text = said(tail, track, {});
  if (given.distance == 0)
    EXPECT_EQ(text, "");
  else
    EXPECT_THAT(text, HasSubstr("at t = 0 s the table is " + write_value(given.distance) +
                                " m away from where the point is"));
  EXPECT_EQ(said(tail, track, {0, 10, false, true}), "");
  EXPECT_EQ(said(tail, track, {},
                 [] {
                   TableDeck deck;
                   deck.relative = true;
                   return deck;
                 }()),
            "");
  EXPECT_EQ(said(tail + R"( from="2")", track, {}), "") << "it comes later";
}
INSTANTIATE_TEST_SUITE_P(CheckSources, Starts,
                         testing::Values(Start{"0,0", "0,20", 0}, Start{"30,0", "30,20", 30},
                                         Start{"0,-30", "0,20", 30}, Start{"3,4", "3,24", 5},
                                         Start{"0.1,0", "0.1,20", 0}, Start{"0.3,0", "0.3,20", 0.3},
                                         Start{"0.3,0", "0.3,0", 0.3}, Start{"0.0005,0", "0,0", 0},
                                         Start{"1,0", "1,0", 1}, Start{"0,1000", "0,1020", 1000}));

TEST(CheckSources, PositionsAreOfOnePoint) {
  const std::string track = "time_s,x_m,y_m\n0,4,1\n10,4,2\n";
  EXPECT_EQ(said(R"(field="displacement" on="tail")", track, {}), "");
  EXPECT_THAT(said(R"(field="displacement" on="cable")", track, {}),
              HasSubstr("a table of positions is for one point, and there are 5 nodes here"));
  EXPECT_THAT(said(R"(field="displacement" on="tail")", "time_s,x_m,y_m\n0,4,3\n10,4,4\n", {}),
              HasSubstr("the table is 2 m away"));
}

// The same said of a table that a condition names by its file.
TEST(CheckSources, InitialValuesAreToldWithTheirPlace) {
  std::ofstream("late.csv") << "time_s,u_m_per_s,v_m_per_s\n5,0,1\n10,0,1\n";
  SampleConditions sample(R"(<initial field="velocity" on="water" table="late.csv"/>)");
  EXPECT_THAT([&] { sample.conditions->set_initial(sample.state); },
              testing::ThrowsMessage<DeckError>(testing::AllOf(
                  StartsWith("d.xml:1:"), HasSubstr("late.csv: no value at t = 0 s"))));
}

}  // namespace
}  // namespace hawser
