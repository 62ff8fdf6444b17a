#include "hawser/physics/moving_point_kernel.hpp"

#include <gtest/gtest.h>

#include "physics/tests/sample_kernels.hpp"
#include "sample_cell.hpp"

namespace hawser {
namespace {

const std::vector<double> X = {0, 0, 4, 1, 1, 3};

struct Moved {
  std::vector<double> temperature = {1, 5, 2};
  std::vector<double> displacement;
  std::vector<double> zero = std::vector<double>(6, 0);
  std::vector<FieldOnCell> fields;
  CellInput cell;
  double residual[9] = {};
  CellStatus status;

  Moved(const Kernel& kernel, const std::vector<double>& reference,
        const std::vector<double>& target) {
    for (std::size_t i = 0; i < target.size(); ++i)
      displacement.push_back(target[i] - reference[i]);
    for (const auto* values : {&temperature, &displacement})
      fields.push_back({values->data(), zero.data(), zero.data(), zero.data(), zero.data()});
    cell.coordinates = reference.data();
    cell.fields = fields.data();
    status = kernel.residual(cell, residual);
  }
};

// A cell moved to another's place gives what that one gives at rest.
TEST(MovingPointKernel, TheReferenceDoesNotMatter) {
  MovingKernel<2> kernel;
  kernel.bind(tabulate_cell({Basis::p1, Basis::p1}, quadrature(CellShape::triangle, 2)));
  const std::vector<double> there = {2, 1, 5, 3, 2.5, 4};
  const Moved moved(kernel, X, there), at_rest(kernel, there, there);
  ASSERT_EQ(moved.status, CellStatus::ok);
  for (int a = 0; a < 3; ++a)
    EXPECT_NEAR(moved.residual[a], at_rest.residual[a], 1e-13);
  // Tested with one: the volume.
  EXPECT_NEAR(moved.residual[0] + moved.residual[1] + moved.residual[2], 4, 1e-13);
}

TEST(MovingPointKernel, AnInvertedCellIsToldWithoutTheAuthor) {
  MovingKernel<2> kernel;
  kernel.bind(tabulate_cell({Basis::p1, Basis::p1}, quadrature(CellShape::triangle, 2)));
  EXPECT_EQ(Moved(kernel, X, {0, 0, 1, 3, 4, 1}).status, CellStatus::inverted);
}

TEST(MovingPointKernel, TheTangentHoldsTheShapeDerivative) {
  MovingKernel<2> plane;
  MovingKernel<3> space;
  for (unsigned seed = 1; seed < 6; ++seed)
    for (const Basis moving : {Basis::p1, Basis::p2}) {
      plane.bind(tabulate_cell({Basis::p2, moving}, quadrature(CellShape::triangle, 4)));
      EXPECT_LE(worst_tangent_error(plane, X, seed), 1e-6);
      space.bind(tabulate_cell({Basis::p1, moving}, quadrature(CellShape::tetrahedron, 2)));
      EXPECT_LE(worst_tangent_error(space, {0, 0, 0, 3, 0, 0.5, 0, 2, 0, 0.3, 0.2, 2}, seed), 1e-6);
    }
}

}  // namespace
}  // namespace hawser
