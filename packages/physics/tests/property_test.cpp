// Properties: constants, laws that others supply, and what the user's tangent makes of them.
#include <gtest/gtest.h>

#include <cmath>

#include "hawser/physics/element_kernel.hpp"
#include "hawser/physics/formula_property.hpp"
#include "hawser/physics/moving_point_kernel.hpp"
#include "hawser/physics/point_property.hpp"
#include "sample_cell.hpp"

namespace hawser {
namespace {

constexpr PropertyUse stiffness{"stiffness", "1"};
constexpr PropertyUse load{"load", "1", 2, 0.0};
constexpr FieldUse scalar{"scalar", "1", "1", 1, RateRule::dynamic};
constexpr FieldUse wind{"wind", "1", "1", 2, RateRule::dynamic};

const std::vector<double> triangle = {0, 0, 1.2, 0.1, 0.3, 0.9};

/// div (k grad u) on the moved mesh, with a load along the gradient.
class Conduction : public MovingPointKernel<Conduction> {
 public:
  static constexpr int dimension = 2;
  static constexpr std::array<FieldUse, 2> uses = {
      scalar.as(Role::adds, need::value | need::gradient),
      StandardFields<2>::displacement.as(Role::reads_if_solved, need::gradient)};
  static constexpr std::array<PropertyUse, 2> properties = {stiffness, load};
  static constexpr Slot<0> u{};
  static constexpr Slot<1> displacement{};
  static constexpr PropertySlot<0> k{};
  static constexpr PropertySlot<1> f{};
  using MovingPointKernel::MovingPointKernel;

  template <class Point, class Form>
  void moved_form(const Point& at, Form& out) const {
    out[u].source = at[f][0] * at[u].value + at[f][1];
    for (int i = 0; i < 2; ++i)
      out[u].flux[i] = at[k] * at[u].gradient[i];
  }
};

/// k = 1 + u^2 + |wind|^2 + |grad wind|^2.
class WindyStiffness : public MovingPointProperty<WindyStiffness> {
 public:
  static constexpr int dimension = 2;
  static constexpr PropertyUse supplies = stiffness;
  static constexpr std::array<FieldUse, 3> uses = {
      scalar.as(Role::reads, need::value), wind.as(Role::reads, need::value | need::gradient),
      StandardFields<2>::displacement.as(Role::reads_if_solved, need::gradient)};
  static constexpr Slot<2> displacement{};
  template <class Point>
  auto moved_law(const Point& at) const {
    using T = typename Point::Number;
    T k = 1.0 + at[Slot<0>()].value * at[Slot<0>()].value;
    const auto& w = at[Slot<1>()];
    for (int i = 0; i < 2; ++i) {
      k += w.value[i] * w.value[i];
      for (int j = 0; j < 2; ++j)
        k += w.gradient(i, j) * w.gradient(i, j);
    }
    return k;
  }
};

/// A traction p n of a property on a facet, p per node.
class Pressing : public ElementKernel<Pressing> {
 public:
  static constexpr int dimension = 2;
  static constexpr CellShape shape = CellShape::triangle;
  static constexpr int node_count = 3;
  static constexpr std::array<FieldUse, 1> uses = {scalar.as(Role::adds, need::value)};
  static constexpr std::array<PropertyUse, 1> properties = {stiffness};
  using ElementKernel::ElementKernel;
  template <class Element, class T>
  void element_residual(const Element& at, T* out) const {
    for (int a = 0; a < 2; ++a)
      out[at.index(0, a, 0)] += at.property(PropertySlot<0>(), a) * at.value(0, a, 0);
  }
};

Supply supply(std::unique_ptr<PropertySource> source) { return {"body", true, std::move(source)}; }

Supply formulas(const PropertyUse& property, const std::vector<std::string>& texts) {
  FieldExpressions expressions;
  for (const std::string& text : texts)
    expressions.emplace_back(text);
  auto source = std::make_unique<FormulaProperty>(property, 2, expressions);
  Diagnostics diagnostics;
  source->resolve({scalar, wind, StandardFields<2>::displacement}, diagnostics);
  EXPECT_TRUE(diagnostics.ok()) << diagnostics.error_text();
  return supply(std::move(source));
}

void bind(Kernel& kernel, Basis scalar_basis = Basis::p1) {
  std::vector<Basis> bases(kernel.fields().size(), Basis::p1);
  bases[0] = scalar_basis;
  kernel.bind(tabulate_cell(bases, quadrature(CellShape::triangle, 4)));
}

std::vector<double> residual_of(const Kernel& kernel, unsigned seed = 2) {
  SampleCell cell(kernel, triangle, seed);
  std::vector<double> residual;
  EXPECT_EQ(cell.residual(-1, 0, residual), CellStatus::ok);
  return residual;
}

TEST(Property, ThatNobodySuppliesIsTheModulesConstant) {
  Conduction plain("body", {std::vector<double>{3}, std::vector<double>{0, 2}});
  bind(plain);
  Conduction supplied("body", {std::vector<double>{0}, std::vector<double>{0, 2}});
  supplied.connect(0, formulas(stiffness, {"3"}));
  bind(supplied);
  const auto expected = residual_of(plain), found = residual_of(supplied);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-14);
  EXPECT_LE(worst_tangent_error(plain, triangle, 2), 1e-6);
}

TEST(Property, HasTheValueOfItsUseWhereNobodyGivesIt) {
  Conduction kernel("body", {std::vector<double>{3}, std::nullopt});
  bind(kernel);
  Conduction zero("body", {std::vector<double>{3}, std::vector<double>{0, 0}});
  bind(zero);
  EXPECT_EQ(residual_of(kernel), residual_of(zero));
}

TEST(Property, SlopesOfALawReachTheTangent) {
  for (const Basis basis : {Basis::p1, Basis::p2}) {
    Conduction kernel("body", {std::vector<double>{0.5}, std::nullopt});
    kernel.connect(0, supply(std::make_unique<WindyStiffness>()));
    kernel.connect(1, formulas(load, {"sin(scalar)", "dx(wind_y)*x + wind_x*dy(scalar) + Y*t"}));
    bind(kernel, basis);
    ASSERT_EQ(kernel.fields().size(), 3u) << "the wind is read for the law alone";
    EXPECT_STREQ(kernel.fields()[2].name, "wind");
    for (unsigned seed = 1; seed <= 10; ++seed)
      EXPECT_LE(worst_tangent_error(kernel, triangle, seed), 1e-6);
  }
}

TEST(Property, OfALawByFormulaIsThatByCode) {
  Conduction code("body", {std::vector<double>{0}, std::nullopt});
  code.connect(0, supply(std::make_unique<WindyStiffness>()));
  bind(code);
  Conduction formula("body", {std::vector<double>{0}, std::nullopt});
  formula.connect(0, formulas(stiffness, {"1 + scalar^2 + wind_x^2 + wind_y^2 + dx(wind_x)^2 + "
                                          "dy(wind_x)^2 + dx(wind_y)^2 + dy(wind_y)^2"}));
  bind(formula);
  const auto expected = residual_of(code), found = residual_of(formula);
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-13);
}

TEST(Property, ContributionsOfSeveralAddUpWhereTheyHold) {
  Conduction kernel("body", {std::vector<double>{1}, std::nullopt});
  kernel.connect(0, formulas(stiffness, {"2"}));
  kernel.connect(0, formulas(stiffness, {"4"}));
  bind(kernel);
  SampleCell cell(kernel, triangle, 2);
  std::vector<double> both, expected;
  EXPECT_EQ(cell.residual(-1, 0, both), CellStatus::ok);
  Conduction seven("body", {std::vector<double>{7}, std::nullopt});
  bind(seven);
  expected = residual_of(seven);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(both[i], expected[i], 1e-13);
  const char first_alone[] = {1, 0};
  std::vector<double> nodal(6, 0.25);
  const FieldOnCell field{nodal.data(), nodal.data(), nodal.data(), nodal.data(), nodal.data()};
  const FieldOnCell fields[] = {field, field};
  CellInput input;
  input.coordinates = triangle.data();
  input.fields = fields;
  input.supplied = first_alone;
  const KernelProperties& properties = static_cast<const Kernel&>(kernel).properties();
  ASSERT_TRUE(properties.evaluate(input, false));
  EXPECT_DOUBLE_EQ(properties.values(0)[0], 3);
}

TEST(Property, IsKnownAtTheNodesOfAFacet) {
  Pressing kernel("body", {std::vector<double>{1}});
  kernel.connect(0, formulas(stiffness, {"scalar + dx(scalar)*y + wind_x"}));
  kernel.bind({});
  EXPECT_EQ(kernel.fields().size(), 3u);
  for (unsigned seed = 1; seed <= 5; ++seed)
    EXPECT_LE(worst_tangent_error(kernel, triangle, seed), 1e-6);
}

TEST(Property, OfAFormulaThatNamesNoFieldIsAFaultWithTheNearestName) {
  FieldExpressions expressions;
  expressions.emplace_back("1 + scaler");
  FormulaProperty source(stiffness, 2, expressions);
  Diagnostics diagnostics;
  source.resolve({scalar, wind}, diagnostics);
  EXPECT_NE(diagnostics.error_text().find("'scaler'"), std::string::npos);
  EXPECT_NE(diagnostics.error_text().find("did you mean 'scalar'"), std::string::npos)
      << diagnostics.error_text();
}

}  // namespace
}  // namespace hawser
