#include "hawser/element/tabulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <tuple>
#include <type_traits>

#include "hawser/element/cell_geometry.hpp"

namespace hawser {
namespace {

constexpr CellShape shapes[] = {CellShape::line, CellShape::triangle, CellShape::quadrilateral,
                                CellShape::tetrahedron, CellShape::hexahedron};

/// Where the nodes of a basis sit by the shape's traits: vertices, middles of edges and faces,
/// centre.
std::vector<double> node_positions(CellShape shape, Basis basis) {
  const ShapeTraits& cell = traits(shape);
  std::vector<double> positions;
  const auto add_middle = [&](const int* vertices, int count) {
    for (int k = 0; k < cell.dimension; ++k) {
      double sum = 0;
      for (int v = 0; v < count; ++v)
        sum += cell.vertex[vertices[v]][k] / count;
      positions.push_back(sum);
    }
  };
  const int all[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const NodeLayout layout = node_layout(shape, basis);
  for (int v = 0; v < cell.vertices; ++v)
    add_middle(all + v, 1);
  for (int e = 0; e < layout.per_edge * cell.edges; ++e)
    add_middle(cell.edge[e], 2);
  for (int f = 0; f < layout.per_face * cell.faces; ++f)
    add_middle(cell.face[f], cell.vertices_per_face);
  if (layout.inside > 0) add_middle(all, cell.vertices);
  return positions;
}

class OnEveryShape : public testing::TestWithParam<std::tuple<CellShape, Basis>> {};
INSTANTIATE_TEST_SUITE_P(Shapes, OnEveryShape,
                         testing::Combine(testing::ValuesIn(shapes),
                                          testing::Values(Basis::p1, Basis::p2)));

// A polynomial of the basis' degree is reproduced, with its gradient, from its values at the nodes:
// their places and their order are those of the traits.
TEST_P(OnEveryShape, NodesAreInTheOrderOfTheTraits) {
  const auto [shape, basis] = GetParam();
  const auto D = static_cast<std::size_t>(traits(shape).dimension);
  const Quadrature rule = quadrature(shape, 4);
  const Tabulation table = tabulate(basis, rule);
  const std::vector<double> place = node_positions(shape, basis);
  ASSERT_EQ(table.nodes, node_layout(shape, basis).count);
  ASSERT_EQ(place.size(), static_cast<std::size_t>(table.nodes) * D);
  const double power = polynomial_degree(basis);
  const auto nodes = static_cast<std::size_t>(table.nodes);
  const auto f = [&](const double* x) {
    double sum = 1;
    for (std::size_t k = 0; k < D; ++k)
      sum += (1.0 + static_cast<double>(k)) * x[k];
    return std::pow(sum, power);
  };
  for (std::size_t q = 0; q < rule.weights.size(); ++q) {
    const double* const xi = &rule.locations[q * D];
    double value = 0;
    for (std::size_t a = 0; a < nodes; ++a)
      value += table.values[q * nodes + a] * f(&place[a * D]);
    EXPECT_NEAR(value, f(xi), 1e-13);
    for (std::size_t k = 0; k < D; ++k) {
      double slope = 0;
      for (std::size_t a = 0; a < nodes; ++a)
        slope += table.gradients[(q * nodes + a) * D + k] * f(&place[a * D]);
      const double exact =
          power * f(xi) / std::pow(f(xi), 1 / power) * (1.0 + static_cast<double>(k));
      EXPECT_NEAR(slope, exact, 1e-12);
    }
  }
}

TEST_P(OnEveryShape, WeightsSumToTheCell) {
  const auto [shape, basis] = GetParam();
  const Quadrature rule = quadrature(shape, 2 * polynomial_degree(basis));
  EXPECT_NEAR(std::accumulate(rule.weights.begin(), rule.weights.end(), 0.0), traits(shape).measure,
              1e-14);
}

TEST(Quadrature, IntegratesPolynomialsOfItsDegreeExactly) {
  const auto integral = [](CellShape shape, int degree, auto&& f) {
    const Quadrature rule = quadrature(shape, degree);
    const auto D = static_cast<std::size_t>(traits(shape).dimension);
    double sum = 0;
    for (std::size_t q = 0; q < rule.weights.size(); ++q)
      sum += rule.weights[q] * f(&rule.locations[D * q]);
    return sum;
  };
  const auto f = [](const double* x) { return x[0] * x[0] * x[0] * x[1] * x[1]; };
  EXPECT_NEAR(integral(CellShape::triangle, 5, f), 12.0 / 5040, 1e-15);  // 3! 2! / 7!
  EXPECT_NEAR(integral(CellShape::tetrahedron, 5, f), 12.0 / 40320, 1e-15);
  EXPECT_NEAR(integral(CellShape::quadrilateral, 3, f), 1.0 / 12, 1e-15);  // degree per direction
  EXPECT_NEAR(integral(CellShape::hexahedron, 3, f), 1.0 / 12, 1e-15);
}

// The facet's area vector times the weights is the facet, seen from outside: the flux of x - x0
// through it is D times the volume of the cone over it to x0, a vertex that it does not have.
TEST(FacetQuadrature, IsOfTheFacetAndItsNormalPointsOutward) {
  const auto flux = [](auto dimension, CellShape shape, const std::vector<double>& X) {
    constexpr int D = decltype(dimension)::value;
    const CellTabulation table = tabulate_cell({}, facet_quadrature(shape, 2));
    CellGeometry<D> geometry;
    geometry.enter(table, X.data());
    double sum = 0;
    for (int q = 0; q < table.rule.points; ++q) {
      geometry.go_to(q, table, X.data());
      const Vector<double, D> normal = geometry.facet();
      for (int j = 0; j < D; ++j)
        sum += table.rule.weights[static_cast<std::size_t>(q)] * normal[j] *
               (geometry.position[j] - X[X.size() - D + static_cast<std::size_t>(j)]);
    }
    return sum;
  };
  EXPECT_NEAR(flux(std::integral_constant<int, 2>(), CellShape::triangle, {0, 0, 4, 1, 1, 3}), 11,
              1e-13);  // twice the area
  EXPECT_NEAR(
      flux(std::integral_constant<int, 2>(), CellShape::quadrilateral, {0, 0, 4, 0, 4, 2, 0, 2}), 8,
      1e-13);
  EXPECT_NEAR(flux(std::integral_constant<int, 3>(), CellShape::tetrahedron,
                   {0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4}),
              12, 1e-13);  // three times the volume
}

TEST(Tabulation, ThereAreNoShapeFunctionsOnAPoint) {
  EXPECT_THROW(quadrature(CellShape::point, 1), std::logic_error);
}

}  // namespace
}  // namespace hawser
