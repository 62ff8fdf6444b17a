// What conditions say that does not fit together, told before the first step.
#include <gmock/gmock.h>

#include <functional>

#include "sample_conditions.hpp"

namespace hawser {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string prescribed(const std::string& field, const std::string& on, const std::string& value,
                       const std::string& more = "") {
  return "<prescribe field=\"" + field + "\" on=\"" + on + "\" value=\"" + value + "\" " + more +
         "/>\n";
}

/// Notes of a run from 0 to 10 s in steps of 1 s.
std::vector<std::string> notes(const std::string& text, const RunSpan& span = {0, 10, 1},
                               const std::function<void(SampleConditions&)>& prepare = {}) {
  SampleConditions sample(text);
  EXPECT_EQ(sample.diagnostics.error_text(), "");
  sample.state.time = span.begin;
  if (prepare) prepare(sample);
  sample.conditions->look_ahead(sample.state, span, sample.diagnostics);
  return sample.diagnostics.notes();
}

struct Pair {
  const char* name;
  std::string text;
  std::string told;  // empty: nothing
};

void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.name; }

class TwoConditions : public testing::TestWithParam<Pair> {};

TEST_P(TwoConditions, AreToldWhereTheyDisagree) {
  const auto told = notes(GetParam().text);
  if (GetParam().told.empty())
    EXPECT_THAT(told, IsEmpty());
  else
    EXPECT_THAT(told, ElementsAre(AllOf(HasSubstr("d.xml:2:2: "), HasSubstr("disagrees with"),
                                        HasSubstr(GetParam().told))));
}

INSTANTIATE_TEST_SUITE_P(
    Varied, TwoConditions,
    testing::Values(
        Pair{"AtTheEndOfALine",
             prescribed("velocity", "cable", "1 0") + prescribed("velocity", "tail", "0 0"),
             "of d.xml:1:14 at 1 node that both have, (4, 1): component x is 0 there, and was to "
             "be 1 (t = 1 s)"},
        Pair{"AtBothEnds",
             prescribed("velocity", "cable", "1 2") + prescribed("velocity", "wall", "1 0"),
             "at 2 nodes that both have, (0, 1), (4, 1): component y is 0 there, and was to be 2"},
        Pair{"EverywhereOnALine",
             prescribed("velocity", "water", "0 0") + prescribed("velocity", "cable", "1 0"),
             "at 5 nodes that both have, (0, 1), (1, 1), (2, 1) and 2 more"},
        Pair{"InOneComponent",
             prescribed("velocity", "cable", "1 0") +
                 prescribed("velocity", "tail", "3", "component=\"y\""),
             "component y is 3 there, and was to be 0"},
        Pair{"InComponentsThatDoNotMeet",
             prescribed("velocity", "cable", "1", "component=\"x\"") +
                 prescribed("velocity", "tail", "3", "component=\"y\""),
             ""},
        Pair{"LaterAlone",
             prescribed("velocity", "cable", "t; 0") +
                 prescribed("velocity", "tail", "min(t, 5); 0"),
             "component x is 5 there, and was to be 10 (t = 10 s)"},
        Pair{"InWindowsThatMeet",
             prescribed("velocity", "cable", "1 0", "until=\"6\"") +
                 prescribed("velocity", "tail", "0 0", "from=\"4\""),
             "(t = 5 s)"},
        Pair{"InWindowsThatDoNotMeet",
             prescribed("velocity", "cable", "1 0", "until=\"4\"") +
                 prescribed("velocity", "tail", "0 0", "from=\"4\""),
             ""},
        Pair{"AVelocityAndADisplacementOfAStructure",
             prescribed("displacement", "cable", "t; 0") + prescribed("velocity", "tail", "0 0"),
             "component x is 0 there, and was to be 1"},
        Pair{
            "Agreeing",
            prescribed("velocity", "cable", "sin(pi*X); 0") + prescribed("velocity", "tail", "0 0"),
            ""},
        Pair{"AgreeingAtTheirNode",
             prescribed("velocity", "cable", "4 - X; 1") + prescribed("velocity", "tail", "0; 1"),
             ""},
        Pair{"AsItIsMeant",
             prescribed("velocity", "cable", "1 0") +
                 prescribed("velocity", "tail", "0 0", "replaces=\"true\""),
             ""}),
    [](const auto& pair) { return pair.param.name; });

TEST(LookAhead, AnOrderTurnedRoundIsToldTheOtherWay) {
  EXPECT_THAT(notes(prescribed("velocity", "tail", "0 0") + prescribed("velocity", "cable", "1 0")),
              ElementsAre(HasSubstr("component x is 1 there, and was to be 0")));
}

TEST(LookAhead, ASteadySolveIsLookedAtInItsEnd) {
  RunSpan steady{0, 1, 1};
  steady.steady = true;
  EXPECT_THAT(
      notes(prescribed("velocity", "cable", "1 0") + prescribed("velocity", "tail", "0 0"), steady),
      ElementsAre(HasSubstr("at 1 node")));
  EXPECT_THAT(notes(prescribed("displacement", "tail", "5 0"), steady), IsEmpty());
}

TEST(LookAhead, ADisplacementThatBeginsElsewhere) {
  const auto first = [](const std::string& value, const std::string& more = "") {
    return notes(prescribed("displacement", "tail", value, more));
  };
  EXPECT_THAT(first("3 4"), ElementsAre(AllOf(HasSubstr("the displacement on 'tail' is 5 m from "
                                                        "its initial value, at (4, 1)"),
                                              HasSubstr("within the first step, of 1 s"))));
  EXPECT_THAT(first("t - 0.5; 0"), ElementsAre(HasSubstr("is 0.5 m from")));
  EXPECT_THAT(first("0; -2*cos(t)"), ElementsAre(HasSubstr("is 2 m from")));
  EXPECT_THAT(first("-30; 0", "until=\"5\""), ElementsAre(HasSubstr("is 30 m from")));
  EXPECT_THAT(first("t; sin(t)"), IsEmpty());
  EXPECT_THAT(first("1e-5; 0"), IsEmpty());            // of edges of 1 m
  EXPECT_THAT(first("9 9", "from=\"5\""), IsEmpty());  // nobody knows where it is then
}

TEST(LookAhead, ADisplacementThatBeginsWhereItIs) {
  const auto text = prescribed("displacement", "tail", "3 4");
  EXPECT_THAT(notes(text, {0, 10, 1},
                    [](SampleConditions& sample) {
                      sample.state.value[sample.row("displacement", 0, 4, 1)] = 3;
                      sample.state.value[sample.row("displacement", 1, 4, 1)] = 4;
                    }),
              IsEmpty());
  RunSpan found{0, 10, 1};
  found.finds_start = true;
  EXPECT_THAT(notes(text, found), IsEmpty());
}

TEST(LookAhead, AWindowOutsideTheRun) {
  const auto window = [](const std::string& more, const RunSpan& span) {
    return notes(prescribed("velocity", "tail", "0 0", more), span);
  };
  EXPECT_THAT(window("from=\"10\"", {0, 10, 1}),
              ElementsAre(HasSubstr("it never holds: the run ends at t = 10 s")));
  EXPECT_THAT(window("until=\"0\"", {0, 10, 1}),
              ElementsAre(HasSubstr("it never holds: the run begins at t = 0 s")));
  EXPECT_THAT(window("from=\"9\"", {0, 10, 1}), IsEmpty());
  RunSpan shortened{0, 5, 1};
  shortened.shortened = true;
  EXPECT_THAT(window("from=\"9\"", shortened), IsEmpty());
}

TEST(LookAhead, AConditionWhereNobodySolvesIsAFault) {
  SampleConditions sample(prescribed("pressure", "tail", "0"));
  EXPECT_THAT(sample.diagnostics.error_text(),
              HasSubstr("no module solves for a field 'pressure'"));
}

TEST(LookAhead, KnowsHowAVertexWillMove) {
  SampleConditions sample(prescribed("displacement", "cable", "3*t; 0") +
                          prescribed("displacement", "tail", "t^2", "component=\"y\""));
  LocalIndex tail = 0;
  for (LocalIndex v = 0; v < sample.mesh.vertices.size(); ++v)
    if (sample.mesh.coordinates[2 * static_cast<std::size_t>(v)] == 4 &&
        sample.mesh.coordinates[2 * static_cast<std::size_t>(v) + 1] == 1)
      tail = v;
  const auto at = [&](const std::string& text) {
    return SampleConditions(text).conditions->prescribed_velocity(tail, 2, sample.state);
  };
  EXPECT_EQ(sample.conditions->prescribed_velocity(tail, 2, sample.state),
            (std::vector<double>{3, 4}));
  EXPECT_EQ(at(prescribed("velocity", "tail", "t; 1")), (std::vector<double>{2, 1}));
  EXPECT_EQ(at(prescribed("displacement", "tail", "t", "component=\"y\"")), std::nullopt);
  EXPECT_EQ(at(prescribed("displacement", "tail", "t; t", "from=\"5\"")), std::nullopt);
}

}  // namespace
}  // namespace hawser
