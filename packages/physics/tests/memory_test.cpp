// What cells remember: read by residuals as plain numbers, advanced where a step is accepted.
#include <gtest/gtest.h>

#include "sample_cell.hpp"
#include "sample_kernels.hpp"

namespace hawser {
namespace {

const std::vector<double> triangle = {0, 0, 4, 1, 1, 3};

TEST(Memory, APointKernelHasItsDoublesAtEveryPoint) {
  CreepKernel kernel;
  const Quadrature rule = quadrature(CellShape::triangle, 2);
  kernel.bind(tabulate_cell({Basis::p1, Basis::p1}, rule));
  EXPECT_EQ(kernel.memory_per_cell(), 2 * rule.points);
  EXPECT_EQ(ScalarKernel<2>().memory_per_cell(), 0);
  for (unsigned seed = 1; seed < 4; ++seed)
    EXPECT_LE(worst_tangent_error(kernel, triangle, seed), 1e-7);
}

// T = 3 x on a mesh that is stretched twofold: grad T = (1.5, 0).
TEST(Memory, ItRelaxesToTheFlux) {
  CreepKernel kernel;
  kernel.bind(tabulate_cell({Basis::p1, Basis::p1}, quadrature(CellShape::triangle, 2)));
  const std::vector<double> T = {0, 12, 3}, d = {0, 0, 4, 1, 1, 3}, zero(6, 0);
  const FieldOnCell fields[] = {{T.data(), zero.data(), zero.data(), zero.data(), zero.data()},
                                {d.data(), zero.data(), zero.data(), zero.data(), zero.data()}};
  std::vector<double> memory(6), next(6);
  for (std::size_t i = 0; i < 6; ++i)
    memory[i] = static_cast<double>(i);
  const CellInput cell{0, 1, triangle.data(), fields, memory.data(), 2};
  kernel.advance_memory(cell, next.data());
  for (std::size_t point = 0; point < 3; ++point) {  // half of the way in 2 s
    EXPECT_NEAR(next[2 * point], 0.5 * (memory[2 * point] + 1.5), 1e-14);
    EXPECT_NEAR(next[2 * point + 1], 0.5 * memory[2 * point + 1], 1e-14);
  }
}

TEST(Memory, AnElementKernelHasItsDoublesPerCell) {
  YieldingSpringKernel kernel;
  ASSERT_EQ(kernel.memory_per_cell(), 1);
  const std::vector<double> X = {0, 0, 1, 0}, d = {0, 0, 1, 0}, zero(4, 0);
  const FieldOnCell field{d.data(), zero.data(), zero.data(), zero.data(), zero.data()};
  const double yielded = 0.5;
  const CellInput cell{0, 1, X.data(), &field, &yielded, 1};
  double residual[4], next = 0;
  ASSERT_EQ(kernel.residual(cell, residual), CellStatus::ok);
  EXPECT_EQ(residual[2], 0.5);
  kernel.advance_memory(cell, &next);
  EXPECT_EQ(next, 0.75);
}

}  // namespace
}  // namespace hawser
