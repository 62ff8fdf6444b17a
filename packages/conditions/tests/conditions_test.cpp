#include "hawser/conditions/conditions.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "hawser/base/error.hpp"
#include "sample_conditions.hpp"

namespace hawser {
namespace {

using testing::HasSubstr;

std::string fault(const std::string& text) {
  return SampleConditions(text).diagnostics.error_text();
}

TEST(Conditions, PrescribeTheComponentsOfAFieldOnARegion) {
  SampleConditions sample(R"(<prescribe field="velocity" on="cable" value="1 + X*t; -Y"/>
                             <prescribe field="velocity" on="tail" component="y" value="7"/>)");
  ASSERT_TRUE(sample.diagnostics.ok()) << sample.diagnostics.error_text();
  const auto rows = sample.prescribed_at(2);
  for (const double x : {0.0, 1.0, 3.0}) {
    EXPECT_EQ(sample.find(rows, "velocity", 0, x, 1)->value, 1 + 2 * x);
    EXPECT_EQ(sample.find(rows, "velocity", 1, x, 1)->value, -1);
  }
  EXPECT_EQ(sample.find(rows, "velocity", 0, 4, 1)->value, 9);
  EXPECT_EQ(sample.find(rows, "velocity", 1, 4, 1)->value, 7);  // the later one holds
  EXPECT_EQ(sample.find(rows, "velocity", 0, 0, 0), nullptr);
  EXPECT_FALSE(sample.conditions->follow_the_mesh());
}

TEST(Conditions, HoldForStepsThatEndWithinTheirWindow) {
  SampleConditions sample(
      R"(<prescribe field="velocity" on="tail" value="1 1" from="2" until="5"/>)");
  EXPECT_EQ(sample.conditions->events(), (std::vector<double>{2, 5}));
  EXPECT_TRUE(sample.prescribed_at(2).empty());
  EXPECT_TRUE(sample.prescribed_at(2 + 1e-7).empty());  // that near to an edge it is the edge
  EXPECT_EQ(sample.prescribed_at(2.1).size(), 2U);
  EXPECT_EQ(sample.prescribed_at(5 + 1e-7).size(), 2U);
  EXPECT_TRUE(sample.prescribed_at(5.1).empty());
}

TEST(Conditions, FollowTheMovedPositionWithTheirExactSlope) {
  SampleConditions sample(R"(<prescribe field="velocity" on="cable" value="x^2*y; X"/>)");
  EXPECT_TRUE(sample.conditions->follow_the_mesh());
  sample.state.value[sample.row("displacement", 0, 3, 1)] = 0.5;
  sample.state.value[sample.row("displacement", 1, 3, 1)] = -0.25;
  const auto rows = sample.prescribed_at(0);
  const PrescribedRow* const moved = sample.find(rows, "velocity", 0, 3, 1);
  EXPECT_EQ(moved->value, 3.5 * 3.5 * 0.75);
  EXPECT_EQ(moved->slope[0], 2 * 3.5 * 0.75);
  EXPECT_EQ(moved->slope[1], 3.5 * 3.5);
  EXPECT_EQ(moved->displacement.count, 1);
  EXPECT_EQ(sample.find(rows, "velocity", 1, 3, 1)->displacement.count, 0);
}

TEST(Conditions, ADisplacementOnAStructurePrescribesItsExactVelocity) {
  SampleConditions sample(
      R"xml(<prescribe field="displacement" on="cable" value="0; 0.2*ramp_distance(t, 0, 10)"/>)xml");
  const auto moving = sample.prescribed_at(5);
  EXPECT_EQ(sample.find(moving, "velocity", 1, 2, 1)->value, 0.1);
  EXPECT_EQ(sample.find(moving, "velocity", 0, 2, 1)->value, 0);
  // In a steady solve a place has no velocity.
  const auto steady = sample.prescribed_at(5, std::numeric_limits<double>::infinity());
  EXPECT_EQ(sample.find(steady, "displacement", 1, 2, 1)->value,
            sample.find(moving, "displacement", 1, 2, 1)->value);
  EXPECT_EQ(sample.find(steady, "velocity", 1, 2, 1)->value, 0);
}

TEST(Conditions, OnTheMeshAloneADisplacementIsNoVelocity) {
  SampleConditions sample(R"(<prescribe field="displacement" on="water" value="X*t; 0"/>)");
  const auto rows = sample.prescribed_at(3);
  EXPECT_EQ(sample.find(rows, "displacement", 0, 2, 0)->value, 6);
  EXPECT_EQ(sample.find(rows, "velocity", 0, 2, 0), nullptr);
  EXPECT_EQ(sample.find(rows, "velocity", 0, 2, 1)->value, 2);
}

// d/dt of x^2 + t^2 at a node that is carried along: 2 t + 2 x dx/dt.
TEST(Conditions, StartWithValuesAndRatesAtTheMovedPlace) {
  SampleConditions sample(R"(<initial field="velocity" on="water" value="x^2 + t^2; 1"/>
                             <initial field="displacement" on="water" value="X/10 + t; 0"/>)");
  sample.state.time = 0.5;
  sample.conditions->set_initial(sample.state);
  const auto at = [&](const char* field, int component) {
    return sample.row(field, component, 2, 1);
  };
  EXPECT_DOUBLE_EQ(sample.state.value[at("displacement", 0)], 0.7);
  EXPECT_DOUBLE_EQ(sample.state.rate[at("displacement", 0)], 1);
  EXPECT_DOUBLE_EQ(sample.state.value[at("velocity", 0)], 2.7 * 2.7 + 0.25);
  EXPECT_DOUBLE_EQ(sample.state.rate[at("velocity", 0)], 1 + 2 * 2.7);
  EXPECT_EQ(sample.state.value[at("velocity", 1)], 1);
}

TEST(Conditions, AValueThatIsNotFiniteIsASolveError) {
  SampleConditions sample(R"(<prescribe field="velocity" on="tail" value="1/t; 0"/>)");
  EXPECT_THROW(sample.prescribed_at(0), SolveError);
}

TEST(Conditions, SayWhatIsWrong) {
  EXPECT_THAT(fault(R"(<prescribe field="velcity" on="cable" value="0 0"/>)"),
              HasSubstr("did you mean 'velocity'"));
  EXPECT_THAT(fault(R"(<prescribe field="velocity" on="cabel" value="0 0"/>)"),
              HasSubstr("did you mean 'cable'"));
  EXPECT_THAT(fault(R"(<prescribe field="velocity" on="cable" value="1 2 3"/>)"),
              HasSubstr("2 values needed for the components x, y of field 'velocity', 3 given; "
                        "formulas are set apart by ';'"));
  EXPECT_THAT(fault(R"(<prescribe field="velocity" on="cable" component="z" value="1"/>)"),
              HasSubstr("field 'velocity' has no component z here; it has x, y"));
  EXPECT_THAT(fault(R"(<prescribe field="velocity" on="cable" value="1 m; 0 m"/>)"),
              HasSubstr("a value is in m, and field 'velocity' is in m/s"));
  EXPECT_THAT(fault(R"(<prescribe field="displacement" on="cable" value="x; 0"/>)"),
              HasSubstr("a displacement cannot depend on x, y or z"));
}

}  // namespace
}  // namespace hawser
