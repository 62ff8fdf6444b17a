#include "hawser/deck/field_expression.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/deck/deck.hpp"
#include "hawser/deck/spec.hpp"

namespace hawser {
namespace {

const SpaceTime somewhere{0.3, -1.7, 0.9, 2.1, -0.4, 1.3, 0.75};

std::string fault(const std::string& formula) {
  FieldExpression expression;
  return FieldExpression::compile(formula, {}, nullptr, expression);
}

TEST(FieldExpression, NamesWhatItNeedsOnceEach) {
  const FieldExpression e("temperature*velocity_y + dx(temperature) - temperature*dz(velocity_y)");
  ASSERT_EQ(e.references().size(), 4U);
  EXPECT_EQ(e.references()[0].text(), "temperature");
  EXPECT_FALSE(e.references()[0].of_vector);
  EXPECT_EQ(e.references()[1].field, "velocity");
  EXPECT_EQ(e.references()[1].component, 1);
  EXPECT_EQ(e.references()[1].along, -1);
  EXPECT_EQ(e.references()[2].text(), "dx(temperature)");
  EXPECT_EQ(e.references()[2].along, 0);
  EXPECT_EQ(e.references()[3].text(), "dz(velocity_y)");
  EXPECT_EQ(e.references()[3].along, 2);
  const double values[] = {2, 3, 5, 7};
  EXPECT_EQ(e(somewhere, values), 2 * 3 + 5 - 2 * 7);
}

TEST(FieldExpression, IsAnExpressionWhereItNamesNoField) {
  EXPECT_TRUE(FieldExpression("2*pi").is_constant());
  EXPECT_TRUE(FieldExpression(3).is_constant());
  EXPECT_EQ(FieldExpression("x^2*t + Y")(somewhere), Expression("x^2*t + Y")(somewhere));
  EXPECT_FALSE(FieldExpression("temperature").is_constant());
  EXPECT_FALSE(FieldExpression("temperature").depends_on_space());
  EXPECT_TRUE(FieldExpression("temperature*x").depends_on_moved_position());
  EXPECT_TRUE(FieldExpression("temperature*X").depends_on_space());
  EXPECT_TRUE(FieldExpression("temperature*t").depends_on_time());
}

/// Of six references, so that the derivatives do not fit one evaluation.
TEST(FieldExpression, DerivativesAreExact) {
  const FieldExpression e("x*a^2 + y*b*c + exp(d)*dx(e) + X*sin(f)*t");
  const double v[] = {2, 3, 5, 0.5, 7, 1.25};
  double slopes[9];
  const SpaceTime& p = somewhere;
  EXPECT_DOUBLE_EQ(e.tangent(p, v, slopes), e(p, v));
  const double exact[] = {4,
                          15,
                          0,
                          4 * p.x,
                          5 * p.y,
                          3 * p.y,
                          7 * std::exp(0.5),
                          std::exp(0.5),
                          p.X * std::cos(1.25) * p.t};
  for (int k = 0; k < 9; ++k)
    EXPECT_DOUBLE_EQ(slopes[k], exact[k]) << k;
  double none[3] = {1, 1, 1};
  EXPECT_EQ(FieldExpression("X*t").tangent(p, nullptr, none), p.X * p.t);
  EXPECT_EQ(none[0], 0);
  EXPECT_EQ(FieldExpression(5).tangent(p, nullptr, none), 5);
  double place[3];
  FieldExpression("x*y*z").tangent(p, nullptr, place);
  EXPECT_EQ(place[1], p.x * p.z);
}

TEST(FieldExpression, KnowsThePolynomialThatItIs) {
  const auto degree = [](const std::string& formula, int place = 1) {
    const FieldExpression e(formula);
    std::vector<int> references;
    for (const FieldReference& reference : e.references())
      references.push_back(reference.along < 0 ? 2 : 1);
    return e.degree(place, references);
  };
  EXPECT_EQ(degree("3"), 0);
  EXPECT_EQ(degree("sin(t)"), 0);
  EXPECT_EQ(degree("x*Y + t"), 2);
  EXPECT_EQ(degree("x*Y + t", 2), 4);
  EXPECT_EQ(degree("-a^2*dx(b)/exp(2*t) + x^3"), 5);
  EXPECT_EQ(degree("a - b"), 2);
  EXPECT_EQ(degree("1/a"), -1);
  EXPECT_EQ(degree("sqrt(a)*b"), -1);
  EXPECT_EQ(degree("t > 1 ? 2 : 3"), 0);
  EXPECT_EQ(degree("a > 1 ? 2 : 3"), -1);
}

TEST(FieldExpression, FaultsHaveTheirOwnSentences) {
  EXPECT_EQ(fault("dx(2*temperature)"),
            "'dx' takes the name of a field, such as dx(temperature) or dx(velocity_x)");
  EXPECT_EQ(fault("dy(x)"),
            "'dy' takes the name of a field, such as dy(temperature) or dy(velocity_x)");
  EXPECT_EQ(fault("dx(temperature, 1)"), fault("dx()"));
  EXPECT_NE(fault("dw(temperature)").find("did you mean 'dx'?"), std::string::npos);
  EXPECT_NE(fault("rmap(t, 0, 1)").find("did you mean 'ramp'?"), std::string::npos);
  EXPECT_EQ(fault("2 temperature"),
            "'temperature' is not expected at character 3 of the expression");
  EXPECT_EQ(fault("1/0"), "its value is not finite");
  // An expression without fields knows neither them nor their derivatives.
  Expression plain;
  EXPECT_NE(Expression::compile("temperature", {}, nullptr, plain), "");
  EXPECT_NE(Expression::compile("dx(t)", {}, nullptr, plain).find("no function 'dx'"),
            std::string::npos);
}

TEST(FieldExpression, AValueThatIsNotFiniteNamesTheFields) {
  const FieldExpression e("1/(a - b)", {"d.xml", 3, 9});
  const double equal[] = {2, 2};
  try {
    e({}, equal);
    FAIL();
  } catch (const SolveError& error) {
    EXPECT_STREQ(error.what(),
                 "d.xml:3:9: the expression '1/(a - b)' is infinite at x = 0, y = 0 m, t = 0 s, "
                 "where a = 2, b = 2");
  }
  const double zero[] = {0};
  double slopes[4];
  EXPECT_THROW(FieldExpression("sqrt(a)").tangent({}, zero, slopes), SolveError);
}

struct Sample {
  FieldExpression one = 1;
  FieldExpressions several = {0, 0};
  static Spec<Sample> spec() {
    return Spec<Sample>("sample", "A sample.")
        .attribute("one", &Sample::one, "W/m", any(), "One.")
        .attribute("several", &Sample::several, "N", any() && length(2), "Two.");
  }
};

Sample read(const std::string& attributes, Diagnostics& faults) {
  return Sample::spec().read(parse_deck("<sample " + attributes + "/>", "d.xml", faults).root,
                             faults);
}

TEST(FieldExpression, IsReadFromADeck) {
  Diagnostics faults;
  const Sample sample = read("one=\"2 kW/km\" several=\"0; 3*temperature\"", faults);
  EXPECT_EQ(faults.error_text(), "");
  EXPECT_EQ(sample.one({}), 2);
  ASSERT_EQ(sample.several.size(), 2U);
  const double temperature = 5;
  EXPECT_EQ(sample.several[1]({}, &temperature), 15);
  EXPECT_EQ(write_value(sample.several), "0; 3*temperature");
  const NodeSpec spec = Sample::spec().node_spec();
  EXPECT_EQ(spec.attributes[0].type, "expression of fields");
  EXPECT_EQ(spec.attributes[0].default_text, "1");
}

TEST(FieldExpression, ParametersComeBeforeFields) {
  const NamedValues names = {{"gain", 4, 4, {}, {}}, {"other", 1, 1, {}, {}}};
  FieldExpression e;
  EXPECT_EQ(FieldExpression::compile("gain*temperature", {}, &names, e), "");
  ASSERT_EQ(e.references().size(), 1U);
  EXPECT_EQ(e.parameters(), std::vector<std::string>{"gain"});
  const double temperature = 5;
  EXPECT_EQ(e({}, &temperature), 20);
  FieldExpression constant;
  EXPECT_EQ(FieldExpression::compile("2*gain", {}, &names, constant), "");
  EXPECT_EQ(constant.parameters(), std::vector<std::string>{"gain"});
  const std::vector<std::string> all = e.names_beside({"temperature"});
  EXPECT_EQ(all.front(), "temperature");
  EXPECT_EQ(all.back(), "other");
}

}  // namespace
}  // namespace hawser
