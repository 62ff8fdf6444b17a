#include "hawser/deck/value.hpp"

#include <gmock/gmock.h>

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
  EXPECT_EQ(fault<double>("1e-3m", {}, "m"), "'m' after the number is not understood (in m)");
  EXPECT_EQ(fault<double>("1 2"), "' 2' after the number is not understood");
  EXPECT_EQ(fault<double>("1,000"),
            "a number has no comma; write 1000 or 1e3 for a thousand and 0.5 for a half");
  for (const char* text : {"nan", "NaN", "inf", "-inf", "infinity"})
    EXPECT_EQ(fault<double>(text), "a finite number is needed") << text;
  for (const char* text : {"1e400", "-1e400", "1e-400"})
    EXPECT_EQ(fault<double>(text), "it is too large or too small for a number of double precision");
  for (const char* text : {"abc", "", "-", "+", "+-1", "e5", "{1,2}"})
    EXPECT_EQ(fault<double>(text), "a number is needed, such as 0.5 or 1e-3") << text;
  EXPECT_EQ(fault<double>("0x10"), "'x10' after the number is not understood");
}

TEST(Value, WholeNumbers) {
  EXPECT_EQ(read<int>("42"), 42);
  EXPECT_EQ(read<int>("-7"), -7);
  for (const char* text : {"3.7", "3.0", "1e3"})
    EXPECT_EQ(fault<int>(text),
              "a whole number is needed, such as 10, without a point or exponent");
  EXPECT_EQ(fault<int>("abc"), "a whole number is needed, such as 10");
  EXPECT_EQ(fault<int>("5x"), "'x' after the number is not understood");
  EXPECT_EQ(fault<int>("99999999999999"), "it is too large; whole numbers go up to 2147483647");
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

TEST(Value, Lists) {
  EXPECT_THAT(read<std::vector<double>>("0  -0.5\n3"), testing::ElementsAre(0, -0.5, 3));
  EXPECT_EQ(fault<std::vector<double>>("0 1x"), "in '1x', 'x' after the number is not understood");
  for (const char* text : {"{1,2,x}", "{1;2}", "1,2"})
    EXPECT_EQ(fault<std::vector<double>>(text),
              "numbers are set apart by blanks, not by ',' or ';'");
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
            "in '1e400', '1e400': it is too large or too small for a number of double precision");
  EXPECT_EQ(fault<Expressions>("1,2"),
            "one value is needed, but ',' makes it 2; components are separated by ';'");
  EXPECT_EQ(fault<Expressions>("0; t; 1", length(2)), "2 values needed, 3 given");
  EXPECT_EQ(fault<Expression>("3 -1"), "one value is needed, 2 are given");
  EXPECT_EQ(fault<Expression>("-1", positive(), "m"), "it must be > 0 m");
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
