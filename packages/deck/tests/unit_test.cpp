#include "hawser/deck/unit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser {
namespace {

Unit unit(const std::string& text) {
  Unit result;
  EXPECT_EQ(read_unit(text, result), "") << text;
  return result;
}

std::string fault(const std::string& text) {
  Unit result;
  return read_unit(text, result);
}

TEST(Unit, FactorsAndDimensions) {
  const struct {
    const char *text, *si;
    double factor;
  } table[] = {{"m/s", "m/s", 1},
               {"kn", "m/s", 1852.0 / 3600},
               {"km/h", "m/s", 1 / 3.6},
               {"kg/m^3", "kg/m^3", 1},
               {"g/cm^3", "kg/m^3", 1000},
               {"kg m^-3", "kg/m^3", 1},
               {"t", "kg", 1000},
               {"N", "N", 1},
               {"MN", "N", 1e6},
               {"kg m/s^2", "N", 1},
               {"N m^2", "kg m^3/s^2", 1},
               {"N*m^2", "kg m^3/s^2", 1},
               {"Pa s", "kg/m/s", 1},
               {"mPa s", "kg/m/s", 1e-3},
               {"N s/m^2", "kg/m/s", 1},
               {"W/(m K)", "kg m/s^3/K", 1},
               {"GPa", "Pa", 1e9},
               {"h", "s", 3600},
               {"min", "s", 60},
               {"ms", "s", 1e-3},
               {"mm", "m", 1e-3},
               {"nmi", "m", 1852},
               {"deg", "rad", std::acos(-1.0) / 180},
               {"deg/s", "rad/s", std::acos(-1.0) / 180},
               {"1/s", "1/s", 1},
               {"Hz", "1/s", 1},
               {"%", "1", 0.01},
               {"1", "1", 1}};
  for (const auto& row : table) {
    EXPECT_EQ(si_text(unit(row.text)), row.si) << row.text;
    EXPECT_NEAR(unit(row.text).factor / row.factor, 1, 1e-15) << row.text;
  }
}

TEST(Unit, WhatItWritesReadsBack) {
  for (const std::string& name : unit_names()) {
    const std::string si = si_text(unit(name));
    EXPECT_EQ(unit(si).factor, 1) << name;
    EXPECT_TRUE(same_dimension(unit(si), unit(name))) << name;
    EXPECT_EQ(si_text(unit(si)), si);
  }
}

TEST(Unit, AnAngleIsNoPlainNumber) {
  EXPECT_FALSE(same_dimension(unit("deg"), unit("1")));
  EXPECT_TRUE(same_dimension(unit("kn"), unit("m/s")));
  EXPECT_FALSE(same_dimension(unit("Pa"), unit("Pa s")));
}

TEST(Unit, Faults) {
  EXPECT_EQ(fault("knots"), "there is no unit 'knots'; did you mean 'kn'?");
  EXPECT_EQ(fault("knt"), "there is no unit 'knt'; did you mean 'kn'?");
  EXPECT_EQ(fault("xyz"), "there is no unit 'xyz'");
  EXPECT_EQ(fault("m//s"), "'/s' is not expected in a unit, such as m/s or kg/m^3");
  EXPECT_EQ(fault("m/"), "the unit ends too early");
  EXPECT_EQ(fault(""), "the unit ends too early");
  EXPECT_EQ(fault("m^x"), "a power of a unit is a whole number, such as m^2");
  EXPECT_EQ(fault("m^0.5"), "'.5' is not expected in a unit, such as m/s or kg/m^3");
  EXPECT_EQ(fault("m^99"), "a power of a unit is a whole number, such as m^2");
  EXPECT_EQ(fault("(m^9)^9"), "powers of a unit go up to 9");
  EXPECT_EQ(fault("W/(m K"), "a closing parenthesis is missing in the unit");
  EXPECT_EQ(fault("m)"), "')' is not expected in a unit, such as m/s or kg/m^3");
  EXPECT_EQ(fault("2 m"), "'2 m' is not expected in a unit, such as m/s or kg/m^3");
  EXPECT_EQ(fault(std::string(70, 'm')),
            "'" + std::string(60, 'm') + "...' is too long for a unit");
}

}  // namespace
}  // namespace hawser
