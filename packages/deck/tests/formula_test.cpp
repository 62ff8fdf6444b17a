// The language of formulas: how strongly operators bind, what functions are worth, and derivatives.
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "hawser/base/error.hpp"
#include "hawser/deck/expression.hpp"

namespace hawser {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const SpaceTime somewhere{0.3, -1.7, 0.9, 2.1, -0.4, 1.3, 0.75};

struct Case {
  const char* formula;
  double value;
};

TEST(Formula, OperatorsBindAsDocumented) {
  const Case cases[] = {{"2 - 3 - 4", -5},
                        {"2/8/4", 0.0625},
                        {"8/2*4", 16},
                        {"2*3 + 4*5", 26},
                        // ^ from the right, above a sign before it, below a sign after it
                        {"2^3^2", 512},
                        {"-2^2", -4},
                        {"(-2)^2", 4},
                        {"2^-2", 0.25},
                        {"2^-2^2", 0.0625},
                        {"2*-3^2", -18},
                        {"2^-1*3", 1.5},
                        {"-2^0.5", -std::sqrt(2.0)},
                        {"2*3^2*2", 36},
                        {"4/-2*3", -6},
                        {"2--2", 4},
                        {"2-+3", -1},
                        {"+3", 3},
                        {"-3*-2", 6},
                        // comparisons give 1 or 0, from the left
                        {"1 < 2 < 3", 1},
                        {"3 > 2 > 1", 0},
                        {"3 > 2 == 1", 1},
                        {"2 < 3 + 1", 1},
                        {"1 + 1 == 2", 1},
                        {"1 <= 1", 1},
                        {"1 >= 2", 0},
                        {"1 != 2", 1},
                        {"-2 < -1", 1},
                        {"1 || 0 && 0", 1},
                        {"0 && 0 || 1", 1},
                        {"2 && 3", 1},
                        {"0.1 && 1", 1},
                        {"0 || 0.1", 1},
                        {"1 == 1 && 2 == 2", 1},
                        // a choice binds weakest, and to the right
                        {"0 ? 2 : 1 ? 4 : 5", 4},
                        {"1 ? 2 ? 3 : 4 : 5", 3},
                        {"0 ? 2 : 3 + 1", 4},
                        {"(1 ? 2 : 3) + 1", 3},
                        {"-1 ? 2 : 3", 2},
                        {"1 ? 2 : 1/0", 2}};
  for (const Case& one : cases) {
    EXPECT_EQ(Expression(one.formula)({}), one.value) << one.formula;
    // The same when nothing is known beforehand.
    std::string varying;
    for (const char c : std::string(one.formula))
      varying += c == '2' ? std::string("(t + 2)") : std::string(1, c);
    EXPECT_EQ(Expression(varying)({}), one.value) << varying;
  }
}

TEST(Formula, FunctionsHaveTheirValues) {
  const Case cases[] = {{"log(exp(2))", 2},
                        {"ln(exp(2))", 2},
                        {"log10(1000)", 3},
                        {"log2(8)", 3},
                        {"rint(2.5)", 3},
                        {"rint(-2.5)", -2},
                        {"rint(-0.6)", -1},
                        {"sign(-3)", -1},
                        {"sign(0)", 0},
                        {"sign(2)", 1},
                        {"abs(-2)", 2},
                        {"min(3, 1, 2)", 1},
                        {"max(1, -2, 3)", 3},
                        {"sum(1, 2, 3)", 6},
                        {"avg(1, 2, 6)", 3},
                        {"sum(2)", 2},
                        {"sqrt(2)^2", 2},
                        {"atan2(1, -1)", 0.75 * std::acos(-1.0)},
                        {"4*atan(1) - pi", 0},
                        {"sin(pi/2) + cos(0)", 2},
                        {"sinh(0.5)/cosh(0.5) - tanh(0.5)", 0},
                        {"asin(sin(0.5)) + acos(cos(0.5)) + tan(atan(2))", 3},
                        {"asinh(sinh(0.5)) + acosh(cosh(0.5)) + atanh(tanh(0.5))", 1.5},
                        {"1e-3 + 1.e3 + .5 + 5.", 1005.501}};
  for (const Case& one : cases)
    EXPECT_NEAR(Expression(one.formula)({}), one.value, 4e-15 * std::fabs(one.value) + 1e-16)
        << one.formula;
}

/// Central differences of eighth order, with the step h: errors of the order of h^8 and 1e-16/h.
double difference(const Expression& formula, double SpaceTime::*variable) {
  constexpr double weights[] = {4. / 5, -1. / 5, 4. / 105, -1. / 280};
  constexpr double h = 4e-3;
  double sum = 0;
  for (int k = 1; k <= 4; ++k) {
    SpaceTime ahead = somewhere, behind = somewhere;
    ahead.*variable += k * h;
    behind.*variable -= k * h;
    sum += weights[k - 1] * (formula(ahead) - formula(behind)) / h;
  }
  return sum;
}

TEST(Formula, DerivativesAreExact) {
  const char* const formulas[] = {
      // each operator and function
      "x + y - z*t", "x/y/z/t", "-x*t", "x^2 + y^3 + z^4 + t^5", "z^t", "2^t", "(z + x)^-1.5",
      "x^y", "(2 + t)^(x*y)", "x*X + Y*t", "abs(y*t)", "acos(x*t)", "acosh(2 + x + t)", "asin(x*t)",
      "asinh(x*t + y)", "atan(x*y + t)", "atan2(x*t, y)", "atan2(y, x + t)", "atanh(x*t)",
      "avg(x, y*t, z^2, 4)", "cos(x*t)", "cosh(x*y + t)", "exp(x*t)", "ln(x + t)", "log(x*t)",
      "log10(x*t)", "log2(x*t)", "max(x*t, y, z*t)", "min(x, y*t, z)", "rint(3*x) + t", "sign(x)*t",
      "sin(x*t)", "sinh(x*t)", "sqrt(x + t)", "sum(x, y*t, z*z)", "tan(x*t)", "tanh(x*t)",
      // ramps: before, between, after, and by each argument
      "ramp(t, 2, 3)", "ramp(t, 0, 3)", "ramp(t, -5, 3)", "ramp(t, x, z)", "ramp_distance(t, 2, 3)",
      "ramp_distance(t, 0, 3)", "ramp_distance(t, -5, 3)", "ramp_distance(t + y/10, x, z)",
      "ramp_distance(t, y, z)",
      // nested, and choices
      "sin(cos(x*t) + exp(-y^2)*sqrt(z^2 + t))^3", "x < t ? x*t : y", "x > t ? x*t : y*t",
      "x < t && y < 0 ? sin(t) : 0", "((x + t)*(y - t))^2/(1 + z^2*t)"};
  constexpr double SpaceTime::*members[] = {&SpaceTime::x, &SpaceTime::y, &SpaceTime::z,
                                            &SpaceTime::t};
  for (const char* text : formulas) {
    const Expression formula(text);
    const Expression::Tangent tangent = formula.tangent(somewhere);
    EXPECT_EQ(tangent.value, formula(somewhere)) << text;
    for (std::size_t k = 0; k < 4; ++k) {
      const double exact = k < 3 ? tangent.gradient[k] : formula.time_derivative(somewhere);
      EXPECT_NEAR(exact, difference(formula, members[k]), 2e-12 * (1 + std::fabs(exact)))
          << text << " in direction " << k;
    }
  }
}

double slope(const char* formula, double x) {
  return Expression(formula).tangent({x, 0, 0, 0, 0, 0, 0}).gradient[0];
}

TEST(Formula, AtAKinkTheDerivativeIsThatOfOneSideOrZero) {
  EXPECT_EQ(slope("abs(x)", 0), 0);
  EXPECT_EQ(slope("sign(x)", 0), 0);
  EXPECT_EQ(slope("max(x, 2*x)", 0), 1);
  EXPECT_EQ(slope("max(2*x, x)", 0), 2);
  EXPECT_EQ(slope("min(0, x)", 0), 0);
  EXPECT_EQ(slope("x < 0 ? 3*x : 5*x", 0), 5);
  EXPECT_EQ(slope("x <= 0 ? 3*x : 5*x", 0), 3);
  EXPECT_EQ(slope("ramp(x, 0, 10)", 0), 0);
  EXPECT_EQ(slope("ramp(x, 0, 10)", 10), 0);
  EXPECT_EQ(slope("ramp_distance(x, 0, 10)", 10), 1);
  EXPECT_EQ(slope("ramp(x, 0, 0)", 0), 0);
}

TEST(Formula, AnInfiniteInnerDerivativeDoesNotMatterWhereNothingDependsOnIt) {
  EXPECT_EQ(slope("sqrt(x)^3", 0), 0);
  EXPECT_EQ(slope("x*sqrt(x)", 0), 0);
  EXPECT_EQ(slope("sqrt(x^2 + y^2)", 0), 0);
  EXPECT_EQ(slope("sqrt(max(0, 1 - x))", 2), 0);
  EXPECT_EQ(slope("x > 0 ? sqrt(x) : 0", 0), 0);
  EXPECT_EQ(slope("(-2)^2*x", 1), 4);
  EXPECT_EQ(slope("x^0", 0), 0);
  EXPECT_EQ(slope("(-x)^3", 2), -12);
  EXPECT_EQ(slope("(-x)^(1 + 2*Y)", 2), -1);
}

TEST(Formula, AnInfiniteDerivativeIsASolveErrorWithPlaceAndTime) {
  const Expression root("sqrt(t)", {"d.xml", 3, 9});
  EXPECT_EQ(root({}), 0);
  try {
    root.time_derivative({});
    FAIL();
  } catch (const SolveError& error) {
    EXPECT_STREQ(error.what(),
                 "d.xml:3:9: the derivative in t of the expression 'sqrt(t)' is infinite at x = 0, "
                 "y = 0 m, t = 0 s");
  }
  EXPECT_THROW(slope("sqrt(1 - x)", 1), SolveError);
  EXPECT_THROW(slope("1/x", 0), SolveError);
}

TEST(Formula, ServesSeveralThreadsAtOnce) {
  const Expression formula("sin(x*t) + x^3*ramp(t, 0, 9)");
  constexpr int count = 20000;
  std::vector<double> results[2];
  const auto fill = [&](std::vector<double>& values, double x) {
    for (int k = 0; k < count; ++k)
      values.push_back(formula.tangent({x, 0, 0, 0, 0, 0, 1e-3 * k}).gradient[0]);
  };
  std::thread other(fill, std::ref(results[0]), 2);
  fill(results[1], -1);
  other.join();
  std::vector<double> alone[2];
  fill(alone[0], 2);
  fill(alone[1], -1);
  EXPECT_EQ(results[0], alone[0]);
  EXPECT_EQ(results[1], alone[1]);
}

TEST(Formula, IsRefusedWhenItIsNestedTooDeeply) {
  const auto fault = [](const std::string& text) {
    Expression result;
    return Expression::compile(text, {}, nullptr, result);
  };
  EXPECT_EQ(fault(std::string(150, '(') + "t" + std::string(150, ')')), "");
  EXPECT_EQ(fault(std::string(100000, '(') + "t"), "the expression is too long");
  std::string tower = "t", nested = "t", long_sum = "t";
  for (int k = 0; k < 100; ++k) {
    nested = "t + (" + nested + ")";
    tower = "t^" + tower;
    long_sum += " + t";
  }
  EXPECT_EQ(fault(nested), "the expression is too long");
  EXPECT_EQ(fault(tower), "the expression is too long");
  EXPECT_EQ(fault(long_sum), "");
}

}  // namespace
}  // namespace hawser
