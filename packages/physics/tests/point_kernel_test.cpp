#include "hawser/physics/point_kernel.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hawser/base/error.hpp"
#include "physics/tests/sample_kernels.hpp"
#include "sample_cell.hpp"

namespace hawser {
namespace {

const std::vector<double> triangle = {0, 0, 4, 1, 1, 3};
const std::vector<double> quadrilateral = {0, 0, 4, 0.5, 2, 2, 0.2, 1.5};
const std::vector<double> tetrahedron = {0, 0, 0, 3, 0, 0.5, 0, 2, 0, 0.3, 0.2, 2};

CellTabulation shapes(CellShape shape, std::vector<Basis> bases, int degree) {
  return tabulate_cell(bases, quadrature(shape, degree));
}

/// The residual of nodal values of one scalar, all rates zero.
std::vector<double> residual_of(const Kernel& kernel, const std::vector<double>& X,
                                const std::vector<double>& values) {
  const std::vector<double> zero(values.size(), 0);
  const FieldOnCell field{values.data(), zero.data(), zero.data(), zero.data(), zero.data()};
  CellInput cell;
  cell.coordinates = X.data();
  cell.fields = &field;
  std::vector<double> result(values.size());
  EXPECT_EQ(kernel.residual(cell, result.data()), CellStatus::ok);
  return result;
}

TEST(PointKernel, MassAndStiffnessOfATriangle) {
  ScalarKernel<2> kernel;
  kernel.bind(shapes(CellShape::triangle, {Basis::p1}, 2));
  const double area = 5.5;
  // Of a constant: its mass alone. Of x: the mass of the nodal values, and the area times grad N.
  const auto of_one = residual_of(kernel, triangle, {1, 1, 1});
  const auto of_x = residual_of(kernel, triangle, {0, 4, 1});
  const double slope[] = {(1.0 - 3) / 11, 3.0 / 11, -1.0 / 11};  // d N / d x
  const double x[] = {0, 4, 1};
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_NEAR(of_one[a], area / 3, 1e-13);
    EXPECT_NEAR(of_x[a], area / 12 * (5 + x[a]) + area * slope[a], 1e-13);
  }
}

// Tested with the sum of all shapes, one, and with x itself: integrals over the cell.
TEST(PointKernel, CellsWhoseMapIsNotAffine) {
  ScalarKernel<2> kernel;
  kernel.bind(shapes(CellShape::quadrilateral, {Basis::p1}, 5));
  const std::vector<double> X = {0, 0, 4, 0, 2, 2, 0, 2};  // a trapezium
  const auto of_x = residual_of(kernel, X, {0, 4, 2, 0});
  EXPECT_NEAR(of_x[0] + of_x[1] + of_x[2] + of_x[3], 28.0 / 3, 1e-12);
  EXPECT_NEAR(4 * of_x[1] + 2 * of_x[2], 20 + 6, 1e-12);  // integral of x^2, and the area
}

TEST(PointKernel, TangentIsTheDerivativeOnEveryShapeAndBasis) {
  ScalarKernel<2> plane;
  ScalarKernel<3> space;
  for (const Basis basis : {Basis::p1, Basis::p2})
    for (unsigned seed = 1; seed < 4; ++seed) {
      plane.bind(shapes(CellShape::triangle, {basis}, 4));
      EXPECT_LE(worst_tangent_error(plane, triangle, seed), 1e-7);
      plane.bind(shapes(CellShape::quadrilateral, {basis}, 4));
      EXPECT_LE(worst_tangent_error(plane, quadrilateral, seed), 1e-7);
      space.bind(shapes(CellShape::tetrahedron, {basis}, 4));
      EXPECT_LE(worst_tangent_error(space, tetrahedron, seed), 1e-7);
    }
}

TEST(PointKernel, EveryFieldFollowsItsOwnVelocity) {
  TwoFollowersKernel kernel;
  EXPECT_EQ(kernel.rate_partner(1), 0);
  EXPECT_EQ(kernel.rate_partner(3), 2);
  const Basis linear = Basis::p1;
  for (const Basis second : {Basis::p1, Basis::p2})  // also where what it follows has fewer nodes
    for (const Basis velocity : {Basis::p1, Basis::p2})
      for (unsigned seed = 1; seed < 6; ++seed) {
        kernel.bind(shapes(CellShape::triangle, {linear, linear, velocity, second}, 4));
        EXPECT_LE(worst_tangent_error(kernel, triangle, seed), 1e-6);
      }
}

TEST(PointKernel, TooManyUnknownsAreAnError) {
  ScalarKernel<2> kernel;
  CellTabulation table = shapes(CellShape::triangle, {Basis::p1}, 2);
  table.fields[0].nodes = 200;
  EXPECT_THAT([&] { kernel.bind(table); },
              testing::ThrowsMessage<PluginError>(testing::HasSubstr(
                  "on 'body' has 200 unknowns and up to 200 nodes per cell; there is room for")));
}

TEST(PointKernel, FacetsAreForKernelsThatSayThatTheyAre) {
  ScalarKernel<2> kernel(Domain::facets("wall"));
  EXPECT_THAT([&] { kernel.bind(shapes(CellShape::triangle, {Basis::p1}, 2)); },
              testing::ThrowsMessage<PluginError>(testing::HasSubstr("on_facets = true")));
}

}  // namespace
}  // namespace hawser
