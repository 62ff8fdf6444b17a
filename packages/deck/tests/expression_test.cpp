#include "hawser/deck/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

SpaceTime at_time(double t) {
  SpaceTime point;
  point.t = t;
  return point;
}

std::string fault(const std::string& formula) {
  Expression expression;
  return Expression::compile(formula, {}, nullptr, expression);
}

TEST(Expression, KnowsWhatItDependsOn) {
  const Expression constant("2*pi + max(1, 2)");
  EXPECT_TRUE(constant.is_constant());
  EXPECT_DOUBLE_EQ(constant({}), 2 * std::acos(-1.0) + 2);
  EXPECT_TRUE(Expression(3).is_constant());
  EXPECT_EQ(Expression()({}), 0);

  const Expression of_time("sin(t)");
  EXPECT_TRUE(of_time.depends_on_time());
  EXPECT_FALSE(of_time.depends_on_space());

  const Expression of_reference("X + t");
  EXPECT_TRUE(of_reference.depends_on_space());
  EXPECT_FALSE(of_reference.depends_on_moved_position());
  EXPECT_TRUE(Expression("x").depends_on_moved_position());
}

TEST(Expression, Evaluates) {
  const SpaceTime point{1, 2, 3, 4, 5, 6, 7};
  const Expression all("x + 10*y + 100*z + 1e3*X + 1e4*Y + 1e5*Z + 1e6*t");
  const Expression copy = all;
  EXPECT_DOUBLE_EQ(all(point), 7654321);
  EXPECT_DOUBLE_EQ(copy({}), 0);
  EXPECT_EQ(Expression("t < 5 ? 1 : 2")(point), 2);
  EXPECT_EQ(Expression("t >= 7 && x == 1 ? 3 : 4")(point), 3);
}

TEST(Expression, RampsAreSmoothAndIntegrate) {
  const Expression ramp("ramp(t, 300, 100)"), distance("0.2*ramp_distance(t, 300, 100)");
  EXPECT_EQ(ramp(at_time(300)), 0);
  EXPECT_DOUBLE_EQ(ramp(at_time(350)), 0.5);
  EXPECT_EQ(ramp(at_time(400)), 1);
  EXPECT_EQ(distance(at_time(299)), 0);
  EXPECT_DOUBLE_EQ(distance(at_time(400)), 10);
  EXPECT_DOUBLE_EQ(distance(at_time(500)), 30);
  for (const double t : {250.0, 300.0, 310.0, 350.0, 399.0, 400.0, 450.0})
    EXPECT_DOUBLE_EQ(distance.time_derivative(at_time(t)), 0.2 * ramp(at_time(t))) << t;
  // Without a duration it is a step.
  EXPECT_EQ(Expression("ramp(t, 1, 0)")(at_time(1.1)), 1);
}

TEST(Expression, Derivatives) {
  const SpaceTime point{1000, -2, 0.5, 7, 8, 9, 3};
  const auto gradient = Expression("x^2*y + sin(z) + X").tangent(point).gradient;
  EXPECT_EQ(gradient[0], -4000);
  EXPECT_EQ(gradient[1], 1e6);
  EXPECT_EQ(gradient[2], std::cos(0.5));
  EXPECT_EQ(Expression("t^3").time_derivative(point), 27);
  EXPECT_EQ(Expression("t").tangent(point).gradient[0], 0);
  EXPECT_EQ(Expression("X*t").tangent(point).value, 21);
  EXPECT_EQ(Expression(5).time_derivative(point), 0);
  // Where the formula ends: sqrt(t)^3 has no value before the start.
  EXPECT_EQ(Expression("sqrt(t)^3").time_derivative(SpaceTime{}), 0);
}

TEST(Expression, FaultsHaveTheirOwnSentences) {
  EXPECT_EQ(fault("rmap(t,0,1)").substr(0, 40), "there is no function 'rmap'; functions a");
  EXPECT_NE(fault("rmap(t,0,1)").find("did you mean 'ramp'?"), std::string::npos);
  EXPECT_EQ(fault("2*T"),
            "the name 'T' is not known; names are X, Y, Z, t, x, y, z, pi; did you mean 't'?");
  EXPECT_EQ(fault("1e-3m"), "'m' after the number 1e-3 is not understood");
  EXPECT_EQ(fault("2x"), "'x' after the number 2 is not understood");
  EXPECT_EQ(fault("1.2.3"), "'1.2.3': '.3' after the number is not understood");
  EXPECT_EQ(fault("nan"), "the name 'nan' is not known; names are X, Y, Z, t, x, y, z, pi");
  EXPECT_EQ(fault("x = 3"), "'=' is not allowed; == compares");
  EXPECT_EQ(fault("1,000"),
            "one value is needed, but ',' makes it 2; components are separated by ';'");
  EXPECT_EQ(fault("sin(t"), "a closing parenthesis is missing");
  EXPECT_EQ(fault("2 +"), "the expression ends too early");
  EXPECT_EQ(fault("ramp(t)"), "too few arguments for the function 'ramp'");
  EXPECT_EQ(fault("sin(t, 1)"), "too many arguments for the function 'sin'");
  EXPECT_EQ(fault("t > 1 ? 2"), "'?' needs its ':'");
  EXPECT_EQ(fault("2*(t > 1 ? 2)"), "'?' needs its ':'");
  EXPECT_EQ(fault("1 : 2"), "':' is not expected at character 3 of the expression");
  EXPECT_EQ(fault("2 + * 3"), "'*' is not expected at character 5 of the expression");
  EXPECT_EQ(fault("--2"), "'-' is not expected at character 2 of the expression");
  EXPECT_EQ(fault("2*(1, t)"), "',' is not expected at character 5 of the expression");
  EXPECT_EQ(fault("max()"), "too few arguments for the function 'max'");
  EXPECT_EQ(fault("2*t kn"), "the name 'kn' is not known; names are X, Y, Z, t, x, y, z, pi");
  EXPECT_EQ(fault("1/0"), "its value is not finite");
  EXPECT_EQ(fault("t )"), "')' is not expected at character 3 of the expression");
  EXPECT_EQ(fault("t; x"), "'; x' is not expected at character 2 of the expression");
  EXPECT_EQ(fault("t t"), "'t' is not expected at character 3 of the expression");
  EXPECT_EQ(fault("\"x\""), "texts are not allowed in an expression");
  EXPECT_EQ(fault("sin"), "the function 'sin' needs its arguments in parentheses");
  EXPECT_EQ(fault(" "), "the expression is empty");
  EXPECT_THROW(Expression("2 +"), DeckError);
}

TEST(Expression, ANonFiniteValueIsASolveErrorWithPlaceAndTime) {
  const Expression inverse("1/(x - 1)", {"d.xml", 3, 9});
  SpaceTime point;
  EXPECT_EQ(inverse(point), -1);
  point.x = 1;
  point.t = 2.5;
  try {
    inverse(point);
    FAIL();
  } catch (const SolveError& error) {
    EXPECT_STREQ(error.what(),
                 "d.xml:3:9: the expression '1/(x - 1)' is infinite at x = 1, y = 0 m, t = 2.5 s");
  }
  EXPECT_THROW(Expression("sqrt(-1 - x*x)")(point), SolveError);
}

}  // namespace
}  // namespace hawser
