#include "hawser/physics/element_kernel.hpp"

#include <gtest/gtest.h>

#include "physics/tests/sample_kernels.hpp"
#include "sample_cell.hpp"

namespace hawser {
namespace {

TEST(ElementKernel, HasANodePerVertexOfItsShape) {
  const SpringKernel spring;
  EXPECT_EQ(spring.shapes(), std::vector<CellShape>{CellShape::line});
  EXPECT_EQ(spring.nodes(0), 2);
  EXPECT_EQ(SpringKernel::unknowns(), 8);
  EXPECT_EQ(spring.rate_partner(1), 0);
  EXPECT_EQ(spring.rate_partner(0), -1);
}

TEST(ElementKernel, TangentIsTheDerivative) {
  const SpringKernel spring;
  for (unsigned seed = 1; seed < 6; ++seed)
    EXPECT_LE(worst_tangent_error(spring, {0, 0, 3, 4}, seed), 1e-7);
}

}  // namespace
}  // namespace hawser
