#include "hawser/element/cell_geometry.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace hawser {
namespace {

/// Integrals of 1 and of x over a cell, and the largest |inverse - d xi / d X| found by
/// differences.
template <int D>
struct Integrals {
  double volume = 0, first_moment = 0;
  Integrals(CellShape shape, const std::vector<double>& X) {
    const CellTabulation table = tabulate_cell({}, quadrature(shape, 4));
    CellGeometry<D> geometry;
    geometry.enter(table, X.data());
    for (int q = 0; q < table.rule.points; ++q) {
      geometry.go_to(q, table, X.data());
      const double weight = table.rule.weights[static_cast<std::size_t>(q)] * geometry.determinant;
      volume += weight;
      first_moment += weight * geometry.position[0];
    }
  }
};

TEST(CellGeometry, AffineCells) {
  const Integrals<2> triangle(CellShape::triangle, {0, 0, 4, 1, 1, 3});
  EXPECT_NEAR(triangle.volume, 5.5, 1e-13);
  EXPECT_NEAR(triangle.first_moment, 5.5 * 5 / 3, 1e-13);
  const Integrals<3> tetrahedron(CellShape::tetrahedron, {1, 0, 0, 3, 0, 0, 1, 3, 0, 1, 0, 4});
  EXPECT_NEAR(tetrahedron.volume, 4, 1e-13);
  EXPECT_NEAR(tetrahedron.first_moment, 4 * 1.5, 1e-13);
}

// A trapezium between y = 0 and 2 whose width falls from 4 to 2: the map is not affine.
TEST(CellGeometry, CellsWhoseMapIsNotAffine) {
  const Integrals<2> trapezium(CellShape::quadrilateral, {0, 0, 4, 0, 2, 2, 0, 2});
  EXPECT_NEAR(trapezium.volume, 6, 1e-13);
  EXPECT_NEAR(trapezium.first_moment, 28.0 / 3, 1e-13);  // integral of (4 - y)^2 / 2
  std::vector<double> frustum;  // that trapezium, drawn out to a height of 3
  for (const double z : {0.0, 3.0})
    for (const auto& corner : {std::pair(0, 0), {4, 0}, {2, 2}, {0, 2}})
      frustum.insert(frustum.end(), {double(corner.first), double(corner.second), z});
  const Integrals<3> solid(CellShape::hexahedron, frustum);
  EXPECT_NEAR(solid.volume, 18, 1e-12);
  EXPECT_NEAR(solid.first_moment, 28, 1e-12);
}

// Gradients by the inverse at the point: of a linear function they are exact on any cell.
TEST(CellGeometry, TheInverseTurnsGradients) {
  const std::vector<double> X = {0, 0, 4, 0.5, 2, 2, 0.2, 1.5};
  const CellTabulation table = tabulate_cell({Basis::p1}, quadrature(CellShape::quadrilateral, 3));
  CellGeometry<2> geometry;
  geometry.enter(table, X.data());
  for (int q = 0; q < table.rule.points; ++q) {
    geometry.go_to(q, table, X.data());
    double gradient[2] = {0, 0};
    for (int a = 0; a < 4; ++a)
      for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
          gradient[j] +=
              table.fields[0].gradients[static_cast<std::size_t>((q * 4 + a) * 2 + k)] *
              geometry.inverse_jacobian(k, j) *
              (3 * X[static_cast<std::size_t>(2 * a)] - 2 * X[static_cast<std::size_t>(2 * a + 1)]);
    EXPECT_NEAR(gradient[0], 3, 1e-13);
    EXPECT_NEAR(gradient[1], -2, 1e-13);
  }
}

TEST(StretchAt, LinesAndSurfacesInSpace) {
  const Quadrature on_line = quadrature(CellShape::line, 1);
  const double line[] = {1, 1, 1, 3, 4, 7};
  EXPECT_NEAR(stretch_at(0, on_line, tabulate(Basis::p1, on_line), line), 7, 1e-13);
  const Quadrature on_triangle = quadrature(CellShape::triangle, 1);
  const double triangle[] = {0, 0, 1, 2, 0, 1, 0, 3, 5};  // normal (0, -8, 6)
  EXPECT_NEAR(stretch_at(0, on_triangle, tabulate(Basis::p1, on_triangle), triangle), 10, 1e-13);
}

}  // namespace
}  // namespace hawser
