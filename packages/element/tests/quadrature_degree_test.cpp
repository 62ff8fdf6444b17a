#include "hawser/element/quadrature_degree.hpp"

#include <gtest/gtest.h>

namespace hawser {
namespace {

constexpr FieldInForm all_of(Basis basis) { return {basis, true, true, true}; }
constexpr FieldInForm slope_of(Basis basis) { return {basis, false, true, true}; }

TEST(QuadratureDegree, LinearTrianglesAsEver) {
  EXPECT_EQ(quadrature_degree(CellShape::triangle, {all_of(Basis::p1)}), 2);
  EXPECT_EQ(quadrature_degree(CellShape::triangle, {{Basis::p1, true, false, true}}), 2);
  EXPECT_EQ(quadrature_degree(CellShape::triangle, {slope_of(Basis::p1)}), 0);
}

TEST(QuadratureDegree, QuadraticFieldsAskForTheirProducts) {
  EXPECT_EQ(quadrature_degree(CellShape::triangle, {all_of(Basis::p2)}), 5);
  EXPECT_EQ(quadrature_degree(CellShape::triangle, {slope_of(Basis::p2)}), 2);
  // Stokes: gradient of a P2 velocity, value of a P1 pressure, both tested.
  EXPECT_EQ(
      quadrature_degree(CellShape::triangle, {slope_of(Basis::p2), {Basis::p1, true, false, true}}),
      4);
  // A linear temperature carried by a quadratic velocity.
  EXPECT_EQ(quadrature_degree(CellShape::triangle,
                              {{Basis::p1, false, true, true}, {Basis::p2, true, false, false}}),
            3);
}

TEST(QuadratureDegree, CubesCountPerDirection) {
  EXPECT_EQ(quadrature_degree(CellShape::quadrilateral, {all_of(Basis::p1)}), 3);  // 2 x 2 points
  EXPECT_EQ(quadrature_degree(CellShape::quadrilateral, {slope_of(Basis::p1)}), 2);
  EXPECT_EQ(quadrature_degree(CellShape::hexahedron, {all_of(Basis::p1)}), 4);
  EXPECT_EQ(quadrature_degree(CellShape::tetrahedron, {all_of(Basis::p1)}), 2);
}

}  // namespace
}  // namespace hawser
