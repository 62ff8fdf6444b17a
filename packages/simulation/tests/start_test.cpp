// A run begins where its deck says: at rest under the conditions of the start.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hawser/base/error.hpp"
#include "sample_deck.hpp"

namespace hawser {
namespace {

/// A heavy cable, laid out straight, longer than the span between the points it is hung from.
const char* const hung_deck = R"deck(<hawser title="Hung">
  <parameter name="length" value="2.022"/>
  <parameter name="span" value="1.805"/>
  <parameter name="release" value="1e9"/>
  <mesh><line from="0 0" to="length; 0" segments="20"/></mesh>
  <modules>
    <cable region="cable" mass-per-length="0.7" axial-stiffness="1e5" slack-width="1e-4"
           gravity="0 -9.81"/>
  </modules>
  <conditions>
    <prescribe field="displacement" on="tow-point" value="0 0"/>
    <prescribe field="displacement" on="tail" until="release" value="span-length; 0"/>
  </conditions>
  <start><equilibrium tolerance="1e-11"/></start>
  <time scheme="newmark" step="0.01" end="10"/>
  <solver><linear method="mumps"/><newton tolerance="1e-9"/></solver>
  <output><probe name="middle" on="middle" field="displacement"/></output>
</hawser>)deck";

struct Solves : Observer {
  std::vector<StartSolve> all;
  void starting(Stepper& /*stepper*/, const StartSolve& solve) override { all.push_back(solve); }
  void attempted(Stepper& /*stepper*/, const Attempt& /*attempt*/) override {}
};

std::string without(std::string text, const std::string& part) {
  return text.erase(text.find(part), part.size());
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

class StartTest : public testing::Test {
 protected:
  Case hung(const std::vector<DeckChange>& changes = {}) {
    return Case::from_text(environment_, hung_deck, "hung.xml", {changes, {}, true});
  }
  /// The farthest that two states are apart, over all nodes and components.
  double apart(const FieldValues& a, const FieldValues& b) const {
    double most = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
      most = std::max(most, std::abs(a.values[i] - b.values[i]));
    return environment_.communicator().max(most);
  }
  Environment environment_;
};

/// Height of the catenary's lowest point below its ends: 2 a sinh(span/2a) = length.
double sag(double span, double length) {
  double low = 0.1, high = 100;
  for (int i = 0; i < 200; ++i) {
    const double a = 0.5 * (low + high);
    (2 * a * std::sinh(span / (2 * a)) > length ? low : high) = a;
  }
  return low * (std::cosh(span / (2 * low)) - 1);
}

TEST_F(StartTest, ACableHangsInItsCatenary) {
  Solves solves;
  Stepper stepper(hung({{"mesh/line/segments", "40"}}));
  stepper.observe(solves);
  stepper.start();
  const FieldValues d = stepper.field("displacement");
  double lowest = 0;
  for (std::size_t i = 1; i < d.values.size(); i += 2)
    lowest = std::min(lowest, d.values[i]);
  // 40 straight segments: their corners lie on the curve but for the square of 1/40; EA stretches
  // by T/EA = 1e-4 at most.
  EXPECT_NEAR(-environment_.communicator().max(-lowest), -sag(1.805, 2.022), 5e-4);
  EXPECT_EQ(stepper.time(), 0);
  EXPECT_FALSE(solves.all.front().why.empty());  // no stiffness, laid out straight
  EXPECT_TRUE(solves.all.back().why.empty());
  EXPECT_EQ(solves.all.back().what, "steady state");
  EXPECT_GT(stepper.summary().number("start_newton_iterations").value_or(0), 1);
}

TEST_F(StartTest, AtEquilibriumNothingMovesInAThousandSteps) {
  const int steps = environment_.communicator().size() == 1 ? 1000 : 50;  // ranks wait much
  for (const char* scheme : {"bdf2", "newmark", "generalised-alpha"}) {
    Stepper stepper(hung({{"time/scheme", scheme}, {"time/end", std::to_string(steps) + "e-2"}}));
    stepper.start();
    const FieldValues before = stepper.field("displacement");
    step_to_the_end(stepper);
    EXPECT_EQ(stepper.steps(), steps);
    EXPECT_LT(apart(before, stepper.field("displacement")), 1e-8) << scheme;
  }
}

TEST_F(StartTest, WhatHoldsUntilTheStartIsLetGoThere) {
  Stepper held(hung()), let_go(hung({{"release", "0"}}));
  held.start();
  let_go.start();
  EXPECT_EQ(apart(held.field("displacement"), let_go.field("displacement")), 0);
  let_go.advance();
  // The end falls with more than its weight alone: the cable pulls it down and in.
  const double fallen = apart(held.field("displacement"), let_go.field("displacement"));
  EXPECT_GT(fallen, 0.5 * 9.81 * 1e-4);
  EXPECT_LT(fallen, 0.02);
}

TEST_F(StartTest, ACableThatNothingHoldsHasNoEquilibrium) {
  Stepper stepper(
      Case::from_text(environment_, hung_deck, "hung.xml",
                      {{{"conditions/prescribe[1]/until", "-1"}, {"release", "-1"}}, {}, true}));
  EXPECT_THROW(stepper.start(), SolveError);
}

TEST_F(StartTest, IsFoundOnceAndNotAgainByARestart) {
  Stepper stepper(hung({{"release", "0"}}));
  for (int i = 0; i < 3; ++i)
    stepper.advance();
  stepper.save("hung.h5");
  Stepper second(Case::from_checkpoint(environment_, "hung.h5"));
  Solves solves;
  second.observe(solves);
  stepper.advance();
  second.advance();
  EXPECT_TRUE(solves.all.empty());
  EXPECT_EQ(second.field("displacement").values, stepper.field("displacement").values);
  EXPECT_EQ(second.summary().number("start_newton_iterations"),
            stepper.summary().number("start_newton_iterations"));
}

/// A stepper of a deck that starts from "other.h5".
const DeckChange from_other{"start/from", "other.h5"};

TEST_F(StartTest, BeginsAtAnotherRunsEndUnderAChangedDeck) {
  Stepper other(hung({{"release", "0"}}));
  for (int i = 0; i < 4; ++i)
    other.advance();
  other.save("other.h5");
  const std::string text = without(hung_deck, "<start><equilibrium tolerance=\"1e-11\"/></start>");
  const auto changed = [&](std::vector<DeckChange> changes) {
    changes.push_back(from_other);
    changes.push_back({"time/scheme", "bdf2"});
    changes.push_back({"time/step", "0.005"});
    changes.push_back({"conditions/prescribe[2]/until", "0"});
    return Case::from_text(environment_, text, "hung.xml", {changes, {}, true});
  };
  Stepper zero(changed({})), continued(changed({{"start/time", "continued"}}));
  EXPECT_EQ(zero.time(), 0);
  EXPECT_EQ(continued.time(), other.time());
  for (const char* field : {"displacement", "velocity"}) {
    EXPECT_EQ(zero.field(field).values, other.field(field).values);
    EXPECT_EQ(continued.field(field).values, other.field(field).values);
  }
  // It falls on where the other one falls: half the step, another scheme, nearly the same way.
  zero.advance();
  zero.advance();
  other.advance();
  EXPECT_LT(apart(zero.field("displacement"), other.field("displacement")), 2e-3);
  EXPECT_GT(apart(zero.field("displacement"), continued.field("displacement")), 5e-3);
}

TEST_F(StartTest, BeginsAtAnotherRunsEndOnTheSameMeshOnly) {
  Stepper other(hung({{"release", "0"}}));
  other.advance();
  other.save("other.h5");
  const auto fault = [&](const DeckChange& change) -> std::string {
    try {
      Stepper stepper(hung({from_other, change}));
    } catch (const DeckError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(fault({"title", "Hung"}), "none");
  EXPECT_THAT(fault({"mesh/line/segments", "22"}),
              testing::HasSubstr("of 21 vertices; here are 23"));
  EXPECT_THAT(fault({"length", "2.1"}), testing::HasSubstr("up to 0.078"));
  EXPECT_THAT(fault({"start/from", "none.h5"}), testing::HasSubstr("none.h5"));
  EXPECT_THAT(fault({"time/end", "0.01"}), testing::Eq("none"));
}

TEST_F(StartTest, AParameterIsLedToItsOwnValue) {
  const std::string led = replaced(
      hung_deck, "<equilibrium tolerance=\"1e-11\"/>",
      "<equilibrium tolerance=\"1e-11\"><continuation parameter=\"span\" from=\"1.9\" steps=\"4\"/>"
      "</equilibrium>");
  Stepper way(Case::from_text(environment_, led, "hung.xml")), straight(hung());
  Solves solves;
  way.observe(solves);
  way.start();
  straight.start();
  EXPECT_LT(apart(way.field("displacement"), straight.field("displacement")), 1e-8);
  std::vector<std::string> found;
  for (const StartSolve& solve : solves.all)
    if (solve.why.empty() && solve.what.find("steady") == 0) found.push_back(solve.what);
  ASSERT_GE(found.size(), 3u);
  EXPECT_EQ(found.front(), "steady state, span = 1.9");
  EXPECT_EQ(found.back(), "steady state, span = 1.805");
  // From a neighbour Newton's method gets there by itself.
  EXPECT_EQ(solves.all.back().why, "");
}

}  // namespace
}  // namespace hawser
