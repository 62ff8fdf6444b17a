#include "hawser/deck/value.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "hawser/deck/diagnostics.hpp"

namespace hawser {
namespace {

template <class T>
std::string fault(const std::string& text, const Rules& rules = {}, const std::string& unit = "1") {
  T value{};
  return read_value(Reading{text, {"d.xml", 1, 1}, unit, rules}, value);
}

template <class T>
T read(const std::string& text) {
  T value{};
  const Rules rules;
  EXPECT_EQ(read_value(Reading{text, {"d.xml", 1, 1}, "1", rules}, value), "") << text;
  return value;
}

TEST(Value, NumbersAreReadWholeOrNotAtAll) {
  EXPECT_EQ(read<double>("0.5"), 0.5);
  EXPECT_EQ(read<double>("-1e-3"), -1e-3);
  EXPECT_EQ(read<double>("+2"), 2);
  EXPECT_EQ(read<double>(".5"), 0.5);
  EXPECT_EQ(fault<double>("0.5abc"), "'abc' after the number is not understood");
  EXPECT_EQ(fault<double>("1e-3m", {}, "m"),
            "a blank is missing between the number and its unit; write '1e-3 m' (in m)");
  EXPECT_EQ(fault<double>("1 2"), "one value is needed, 2 are given");
  EXPECT_EQ(fault<double>("1,000"),
            "a number has no comma; write 1000 or 1e3 for a thousand, 0.5 for a half, and blanks "
            "between the values of a list");
  for (const char* text : {"nan", "NaN", "inf", "-inf", "infinity"})
    EXPECT_EQ(fault<double>(text), "a finite number is needed") << text;
  for (const char* text : {"1e400", "-1e400", "1e-400"})
    EXPECT_EQ(fault<double>(text), "it is too large or too small for a number of double precision");
  for (const char* text : {"-", "+", "+-1"})
    EXPECT_EQ(fault<double>(text), "a number is needed, such as 0.5 or 1e-3") << text;
  for (const char* text : {"abc", "e5"})
    EXPECT_EQ(fault<double>(text),
              "a number is needed, such as 0.5 or 1e-3, or the name of a parameter; there are none")
        << text;
  EXPECT_EQ(fault<double>("0x10"), "'x10' after the number is not understood");
}

TEST(Value, WholeNumbers) {
  EXPECT_EQ(read<int>("42"), 42);
  EXPECT_EQ(read<int>("-7"), -7);
  for (const char* text : {"3.7", "3.0", "1e3"})
    EXPECT_EQ(fault<int>(text),
              "a whole number is needed, such as 10, without a point or exponent");
  EXPECT_EQ(fault<int>("abc"),
            "a number is needed, such as 0.5 or 1e-3, or the name of a parameter; there are none");
  EXPECT_EQ(fault<int>("5x"), "'x' after the number is not understood");
  EXPECT_EQ(fault<int>("99999999999999"), "it is too large; whole numbers go up to 2147483647");
}

// Everything that is nearly a count, each with its own sentence.
TEST(Value, WhatIsNoWholeNumberIsToldWhy) {
  const std::string comma =
      "a number has no comma; write 1000 or 1e3 for a thousand, 0.5 for a half, and blanks between "
      "the values of a list";
  const std::string braces =
      "values are written without braces or brackets, and set apart by blanks: '0 -0.5'";
  const std::pair<const char*, std::string> table[] = {
      {"99999999999999", "it is too large; whole numbers go up to 2147483647"},
      {"3.7", "a whole number is needed, such as 10, without a point or exponent"},
      {"abc",
       "a number is needed, such as 0.5 or 1e-3, or the name of a parameter; there are none"},
      {"0.5abc", "'abc' after the number is not understood"},
      {"1,000", comma},
      {"1e-3m", "'m' after the number is not understood"},
      {"nan", "a finite number is needed"},
      {"inf", "a finite number is needed"},
      {"1e400", "it is too large or too small for a number of double precision"},
      {"{1,2,x}", braces},
      {"{1;2}", braces},
      {"5 m", "a count has no unit"},
      {"1 2", "one value is needed, 2 are given"},
      {"7/2", "a whole number is needed, and this is 3.5"}};
  for (const auto& [text, sentence] : table)
    EXPECT_EQ(fault<int>(text, {}, ""), sentence) << text;
}

TEST(Value, TruthAndWords) {
  EXPECT_TRUE(read<bool>("true"));
  EXPECT_FALSE(read<bool>("false"));
  for (const char* text : {"1", "yes", "True", "truefalse"})
    EXPECT_EQ(fault<bool>(text), "it must be true or false") << text;
  EXPECT_EQ(fault<std::string>("gnres", one_of({"gmres", "mumps"})),
            "it must be one of gmres, mumps; did you mean 'gmres'?");
}

TEST(Value, Ranges) {
  EXPECT_EQ(fault<double>("0", positive(), "kg/m^3"), "it must be > 0 kg/m^3");
  EXPECT_EQ(fault<double>("1.5", between(0, 1)), "it must be from 0 to 1");
  EXPECT_EQ(fault<int>("0", at_least(1)), "it must be >= 1");
  EXPECT_EQ(fault<int>("9", at_least(1) && at_most(8)), "it must be <= 8");
  EXPECT_EQ((required() && positive() && less_than(2) && length(1, 3)).range_text(),
            "> 0, < 2, 1 to 3 values");
}

// A blank between values that are no numbers is no separator, and the message says what is.
TEST(Value, FormulasInListsAreSetApartBySemicolons) {
  const NamedValues names{{"L", 420, 420, std::nullopt, {}}, {"H", 10, 10, std::nullopt, {}}};
  const auto said = [&](const std::string& text) {
    const Rules rules = any();
    std::vector<double> value;
    Expressions formulas;
    const std::string list = read_value({text, {}, "m", rules, &names}, value);
    EXPECT_FALSE(read_value({text, {}, "m", rules, &names}, formulas).empty()) << text;
    return list;
  };
  for (const auto& [text, apart] : {std::pair("L 0", "L; 0"),
                                    {"0 L", "0; L"},
                                    {"L H", "L; H"},
                                    {"-L 0", "-L; 0"},
                                    {"2*L 0", "2*L; 0"},
                                    {"L/2 H/2", "L/2; H/2"},
                                    {"L  0  H", "L; 0; H"},
                                    {"sqrt(L) 1", "sqrt(L); 1"},
                                    {"L 1e-3", "L; 1e-3"},
                                    {"H 0 0", "H; 0; 0"}}) {
    EXPECT_THAT(said(text), testing::EndsWith(std::string("; values of a list that are names or "
                                                          "formulas are set apart by ';': '") +
                                              apart + "'"))
        << text;
  }
  EXPECT_THAT(said("L none"), testing::Not(testing::HasSubstr("set apart")));
}

TEST(Value, Lists) {
  EXPECT_THAT(read<std::vector<double>>("0  -0.5\n3"), testing::ElementsAre(0, -0.5, 3));
  EXPECT_EQ(fault<std::vector<double>>("0 1x"), "in '1x', 'x' after the number is not understood");
  const std::string braces =
      "values are written without braces or brackets, and set apart by blanks: '0 -0.5'";
  EXPECT_EQ(fault<std::vector<double>>("{1,2,x}"), braces);
  EXPECT_EQ(fault<std::vector<double>>("{1;2}"), "in '{1', " + braces);
  EXPECT_EQ(fault<std::vector<double>>("1,2"),
            "a number has no comma; write 1000 or 1e3 for a thousand, 0.5 for a half, and blanks "
            "between the values of a list");
  EXPECT_EQ(fault<std::vector<double>>("1 2 3", length(2)), "2 values needed, 3 given");
  EXPECT_EQ(fault<std::vector<double>>("1 -2", positive()), "in '-2', it must be > 0");
  EXPECT_THAT(read<std::vector<std::string>>("a b"), testing::ElementsAre("a", "b"));
  EXPECT_EQ(fault<std::vector<std::string>>("a, b"),
            "in 'a,', names are set apart by blanks, not by ',' or ';'");
}

TEST(Value, ListsOfExpressions) {
  const auto plain = read<Expressions>("0 -0.5");
  ASSERT_EQ(plain.size(), 2u);
  EXPECT_EQ(plain[1]({}), -0.5);
  const auto mixed = read<Expressions>("0; -0.5*ramp(t, 0, 10)");
  ASSERT_EQ(mixed.size(), 2u);
  EXPECT_TRUE(mixed[0].is_constant());
  EXPECT_EQ(mixed[1]({0, 0, 0, 0, 0, 0, 20}), -0.5);
  EXPECT_EQ(write_value(mixed), "0; -0.5*ramp(t, 0, 10)");
  EXPECT_EQ(fault<Expressions>("0;;1"), "in '', a value is missing beside a ';'");
  EXPECT_EQ(fault<Expressions>("0; 1e400"),
            "in '1e400', it is too large or too small for a number of double precision");
  EXPECT_EQ(fault<Expressions>("1,2"),
            "a number has no comma; write 1000 or 1e3 for a thousand, 0.5 for a half, and blanks "
            "between the values of a list");
  EXPECT_EQ(fault<Expressions>("0; t; 1", length(2)), "2 values needed, 3 given");
  EXPECT_EQ(fault<Expression>("3 -1"), "one value is needed, 2 are given");
  EXPECT_EQ(fault<Expression>("-1", positive(), "m"), "it must be > 0 m");
}

TEST(Value, NumbersWithUnits) {
  const auto in = [](const std::string& text, const std::string& unit) {
    double value = 0;
    const Rules rules;
    EXPECT_EQ(read_value(Reading{text, {"d.xml", 1, 1}, unit, rules}, value), "") << text;
    return value;
  };
  EXPECT_EQ(in("0.5 m/s", "m/s"), 0.5);
  EXPECT_EQ(in("36 km/h", "m/s"), 10);
  EXPECT_EQ(in("1 h", "s"), 3600);
  EXPECT_EQ(in("30 deg", "deg"), 30);
  EXPECT_DOUBLE_EQ(in("1 rad", "deg"), 180 / std::acos(-1.0));
  EXPECT_DOUBLE_EQ(in("asin(1)", "deg"), 90);  // a formula is in SI units
  EXPECT_EQ(in("30", "deg"), 30);
  EXPECT_EQ(in("50 %", "1"), 0.5);
  EXPECT_EQ(in("0.15 km", "as the quantity"), 150);
  EXPECT_EQ(in("2*3", "m"), 6);
  EXPECT_EQ(fault<double>("3 kn", {}, "kg/m^3"),
            "it is in kn, hence m/s, and a value in kg/m^3 is needed, such as '3 kg/m^3'");
  EXPECT_EQ(fault<double>("3 m", {}, "1"), "it is in m, and a plain number is needed, such as '3'");
  EXPECT_EQ(fault<int>("3 m", {}, ""), "a count has no unit");
  EXPECT_EQ(fault<double>("3 meters", {}, "m"), "there is no unit 'meters'; did you mean 'm'?");
  EXPECT_EQ(fault<double>("-1 km", positive(), "m"), "it must be > 0 m");
  EXPECT_EQ(read<int>("2*3"), 6);
  EXPECT_EQ(fault<int>("7/2"), "a whole number is needed, and this is 3.5");
  EXPECT_EQ(fault<int>("1e6*1e6"), "a whole number is needed, and this is 1e+12");
}

TEST(Value, ListsWithUnits) {
  const auto in = [](const std::string& text) {
    std::vector<double> value;
    const Rules rules;
    EXPECT_EQ(read_value(Reading{text, {"d.xml", 1, 1}, "m", rules}, value), "") << text;
    return value;
  };
  EXPECT_THAT(in("0 -420 m"), testing::ElementsAre(0, -420));
  EXPECT_THAT(in("0 1 km"), testing::ElementsAre(0, 1000));
  EXPECT_THAT(in("5 m -0.5 km"), testing::ElementsAre(5, -500));
  EXPECT_THAT(in("0; 2*3 + 1"), testing::ElementsAre(0, 7));
  EXPECT_THAT(in("1 m; 1 km"), testing::ElementsAre(1, 1000));
  EXPECT_EQ(fault<std::vector<double>>("1 m 2", {}, "m"),
            "every value of the list needs its unit, or only the last one, for all");
  EXPECT_EQ(fault<std::vector<double>>("0 1 kn", {}, "m"),
            "in '0 kn', it is in kn, hence m/s, and a value in m is needed, such as '0 m'");
  EXPECT_EQ(fault<std::vector<double>>("a b", {}, "m"),
            "the name 'a' is not known; names are X, Y, Z, t, x, y, z, pi");
}

TEST(Value, WrittenValuesReadBackTheSame) {
  for (const double value : {0.1, 1e-300, 1000.0, -1.0 / 3.0, 1e22})
    EXPECT_EQ(read<double>(write_value(value)), value);
  EXPECT_EQ(write_value(1000.0), "1000");
  EXPECT_EQ(write_value(std::vector<double>{1, 0.5}), "1 0.5");
  EXPECT_EQ(write_value(true), "true");
  EXPECT_EQ(write_value(std::optional<int>()), "");
}

TEST(Value, NearestName) {
  const std::vector<std::string> names{"density", "viscosity", "dt"};
  EXPECT_EQ(nearest_name("desity", names), "density");
  EXPECT_EQ(nearest_name("dentisy", names), "density");
  EXPECT_EQ(nearest_name("Viscosity", names), "viscosity");
  EXPECT_EQ(nearest_name("td", names), "dt");
  EXPECT_EQ(nearest_name("pressure", names), "");
}

}  // namespace
}  // namespace hawser
