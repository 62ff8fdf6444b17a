// Named values of a deck.
#include "deck_reading.hpp"

namespace hawser {
namespace {

TEST_F(DeckReading, ParametersAreValuesOfEveryNumberAndFormula) {
  write("case.xml", base_deck);
  const double knot = 1852.0 / 3600;
  EXPECT_DOUBLE_EQ(run().prescribed[0].value[1]({}), -2 * knot);
  EXPECT_DOUBLE_EQ(run({"time/step=across"}).time.step, knot);
  // A bare number is in the parameter's unit.
  EXPECT_DOUBLE_EQ(run({"angle=90", "time/step=across"}).time.step, 2 * knot);
  EXPECT_EQ(run({"speed=5", "time/step=2*speed + 1"}).time.step, 11);
  EXPECT_EQ(diagnostics_.error_text(), "");
  EXPECT_EQ(
      faults({"time/step=speed"}),
      "--set time/step=speed: attribute 'step' of <time> is 'speed': the parameter 'speed' is "
      "in kn, and a value in s is needed, such as '1 s'");
  EXPECT_EQ(faults({"time/step=t"}),
            "--set time/step=t: attribute 'step' of <time> is 't': one fixed number is needed, but "
            "this depends on place or time");
  EXPECT_EQ(faults({"time/step=sped"}),
            "--set time/step=sped: attribute 'step' of <time> is 'sped': a number is needed, such "
            "as 0.5 or 1e-3, or the name of a parameter; there are speed, angle, across; did you "
            "mean 'speed'?");
}

TEST_F(DeckReading, FaultyParameters) {
  const auto parameter = [&](const std::string& attributes) {
    write("case.xml",
          "<hawser>\n<parameter name='a' value='1'/>\n<parameter " + attributes + "/>\n</hawser>");
    return faults();
  };
  EXPECT_EQ(parameter("name='tow-speed' value='1'"),
            "case.xml:3:12: attribute 'name' of <parameter> is 'tow-speed': a name in formulas has "
            "letters, digits and _ only, such as tow_speed");
  EXPECT_EQ(
      parameter("name='ramp' value='1'").substr(0, 88),
      "case.xml:3:12: attribute 'name' of <parameter> is 'ramp': formulas use this name already");
  EXPECT_EQ(
      parameter("name='a' value='1'"),
      "case.xml:3:12: attribute 'name' of <parameter> is 'a': a parameter of this name stands "
      "at case.xml:2:2 already");
  EXPECT_EQ(parameter("name='b' value='2*c'"),
            "case.xml:3:21: attribute 'value' of <parameter> is '2*c': the name 'c' is not known; "
            "names are X, Y, Z, t, x, y, z, a, pi");
  EXPECT_EQ(
      parameter("name='b' unit='s' value='3 m'"),
      "case.xml:3:30: attribute 'value' of <parameter> is '3 m': it is in m, and a value in s "
      "is needed, such as '3 s'");
  EXPECT_EQ(
      parameter("name='b' unit='metre' value='3'"),
      "case.xml:3:21: attribute 'unit' of <parameter> is 'metre': there is no unit 'metre'; did "
      "you mean 'm'?");
  EXPECT_EQ(parameter("value='3'"),
            "case.xml:3:2: <parameter> needs the attribute 'name' (text): Name.");
}

TEST_F(DeckReading, AParameterThatNothingUsesIsAFaultWhereAnotherOneWasMeant) {
  write("sub/base.xml", base_deck);
  write("case.xml",
        "<hawser extends='sub/base.xml'>\n"
        "  <parameter name='sped' value='3 kn'/>\n"
        "</hawser>");
  EXPECT_EQ(faults(), "case.xml:2:4: nothing uses the parameter 'sped'; did you mean 'speed'?");
  write("case.xml",
        "<hawser extends='sub/base.xml'>\n"
        "  <parameter name='sped' value='3 kn'/>\n"
        "  <prescribe name='inflow' value='0; -sped'/>\n"
        "  <parameter name='for_an_extending_deck' value='1'/>\n"
        "</hawser>");
  EXPECT_EQ(faults(), "");
}

}  // namespace
}  // namespace hawser
