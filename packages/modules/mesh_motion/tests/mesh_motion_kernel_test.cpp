#include "mesh_motion_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sample_cell.hpp"

namespace hawser {
namespace {

const std::vector<double> triangle = {0, 0, 4, 1, 1, 3};
const std::vector<double> quadrilateral = {0, 0, 4, 0.5, 2, 2, 0.2, 1.5};
const std::vector<double> tetrahedron = {0, 0, 0, 3, 0, 0.5, 0, 2, 0, 0.3, 0.2, 2};

template <int D>
double worst_error(CellShape shape, Basis basis, const std::vector<double>& coordinates) {
  double worst = 0;
  for (const bool incremental : {true, false}) {
    MeshMotionKernel<D> kernel("water", {incremental, 1, 0.3});
    kernel.bind(tabulate_cell({basis}, quadrature(shape, 2)));
    for (unsigned seed = 1; seed < 4; ++seed)
      worst = std::max(worst, worst_tangent_error(kernel, coordinates, seed));
  }
  return worst;
}

TEST(MeshMotionKernel, TangentIsTheDerivativeOnEveryShapeAndBasis) {
  for (const Basis basis : {Basis::p1, Basis::p2}) {
    EXPECT_LE(worst_error<2>(CellShape::triangle, basis, triangle), 1e-6);
    EXPECT_LE(worst_error<2>(CellShape::quadrilateral, basis, quadrilateral), 1e-6);
    EXPECT_LE(worst_error<3>(CellShape::tetrahedron, basis, tetrahedron), 1e-6);
  }
}

std::vector<double> residual_of(const Kernel& kernel, const std::vector<double>& coordinates,
                                const std::vector<double>& displacement) {
  const std::vector<double> zero(displacement.size(), 0);
  const FieldOnCell field{displacement.data(), zero.data(), zero.data(), zero.data(), zero.data()};
  const CellInput cell{0, 0.1, coordinates.data(), &field};
  std::vector<double> result(displacement.size());
  EXPECT_EQ(kernel.residual(cell, result.data()), CellStatus::ok);
  return result;
}

TEST(MeshMotionKernel, ATranslationCostsNothing) {
  MeshMotionKernel<3> kernel("water", {});
  kernel.bind(tabulate_cell({Basis::p1}, quadrature(CellShape::tetrahedron, 0)));
  for (const double force : residual_of(kernel, tetrahedron, {1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3}))
    EXPECT_NEAR(force, 0, 1e-12);
}

// E goes with the size of the cell to minus `power`, a size that is an area in the plane and a
// volume in space: a cell twice as large is less stiff by 2^(-D power), its forces in all by
// 2^(D - 1) 2^(-D power) under the same strain.
template <int D>
void check_stiffening(CellShape shape, const std::vector<double>& coordinates, double power) {
  MeshMotionKernel<D> kernel("water", {true, power, 0.3});
  kernel.bind(tabulate_cell({Basis::p1}, quadrature(shape, 0)));
  std::vector<double> large = coordinates, stretched(coordinates.size(), 0);
  for (double& x : large)
    x *= 2;
  for (std::size_t i = 0; i < stretched.size(); i += D)
    stretched[i] = 0.1 * coordinates[i];
  const auto of_small = residual_of(kernel, coordinates, stretched);
  for (double& d : stretched)
    d *= 2;
  const auto of_large = residual_of(kernel, large, stretched);
  for (std::size_t i = 0; i < of_small.size(); ++i)
    EXPECT_NEAR(of_large[i], of_small[i] * std::pow(2, D - 1 - D * power), 1e-12);
}

TEST(MeshMotionKernel, SmallCellsAreStiff) {
  check_stiffening<2>(CellShape::triangle, triangle, 1);
  check_stiffening<3>(CellShape::tetrahedron, tetrahedron, 0.5);
}

// The factor in front is that of the cell's own measure, not of a triangle's.
TEST(MeshMotionKernel, AUnitCubeHasUnitStiffness) {
  MeshMotionKernel<2> kernel("water", {true, 1, 0});
  kernel.bind(tabulate_cell({Basis::p1}, quadrature(CellShape::quadrilateral, 2)));
  const auto forces = residual_of(kernel, {0, 0, 1, 0, 1, 1, 0, 1}, {0, 0, 0.1, 0, 0.1, 0, 0, 0});
  EXPECT_NEAR(forces[2] + forces[4], 0.1, 1e-14);  // stress E 0.1 over a side of 1
}

}  // namespace
}  // namespace hawser
