#include "src/block_norms.hpp"

#include <gtest/gtest.h>

#include "pointwise_problem.hpp"

namespace hawser {
namespace {

using test::PointwiseProblem;

/// Ten rows on all ranks, of a derivative of -2 each; the first one on each rank is a block.
struct BlockNorms : testing::Test {
  BlockNorms() {
    auto& blocks = problem.system().blocks;
    blocks.push_back({"lower", "depth", "kg", {blocks[0].rows.front()}});
    blocks[0].rows.erase(blocks[0].rows.begin());
    problem.jacobian(problem.guess(1));
  }
  std::vector<BlockNorm> norms(double residual, double magnitude, double round_off = 0) {
    return block_norms(problem.system(), problem.guess(residual), problem.guess(magnitude),
                       {{}, {1, 0}}, round_off);
  }
  const BlockSystem& system() { return problem.system(); }

  PointwiseProblem problem{[](double x) { return -2 * x; }, [](double) { return -2; }};
  const double lower = Communicator().size();  ///< rows of each block
  const double upper = 10 - lower;
};

TEST_F(BlockNorms, AreTwoNormsOverAllRanksAndTheirRatio) {
  const auto found = norms(-3, 4);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].block, "upper");
  EXPECT_EQ(found[1].unit, "kg");
  EXPECT_DOUBLE_EQ(found[0].residual, 3 * std::sqrt(upper));
  EXPECT_DOUBLE_EQ(found[0].magnitude, 4 * std::sqrt(upper));
  EXPECT_DOUBLE_EQ(found[1].residual, 3 * std::sqrt(lower));
  EXPECT_DOUBLE_EQ(found[0].ratio, 0.75);
}

TEST_F(BlockNorms, ARoundedResidualIsNone) {
  EXPECT_EQ(norms(1e-15, 1e-15, 1e-14)[0].ratio, 0);
  EXPECT_EQ(norms(1e-15, 1e-15, 1e-14)[1].ratio, 1);
  EXPECT_EQ(norms(0, 0)[0].ratio, 0);
}

TEST_F(BlockNorms, ProductMagnitudesAreOfAbsoluteValues) {
  const auto found = jacobian_scales(system(), problem.guess(-5)).products;
  EXPECT_DOUBLE_EQ(found[0], 10 * std::sqrt(upper));
  EXPECT_DOUBLE_EQ(found[1], 10 * std::sqrt(lower));
}

// f = -2 x: a residual of 3 says that x is off by 1.5, of a size of 6.
TEST_F(BlockNorms, AnUnknownWithASizeIsJudgedByHowMuchItIsOff) {
  auto& block = problem.system().blocks[0];
  block.sizes.assign(block.rows.size(), 6);
  const auto scales = jacobian_scales(system(), problem.guess(-5));
  const auto found =
      block_norms(system(), problem.guess(-3), problem.guess(1e-30), scales, 1e-14)[0];
  EXPECT_DOUBLE_EQ(found.residual, 1.5 * std::sqrt(upper));
  EXPECT_DOUBLE_EQ(found.ratio, 0.25);
  EXPECT_DOUBLE_EQ(scales.products[0], 5 * std::sqrt(upper));  // in the unknown's unit, too
}

TEST_F(BlockNorms, TheWorstIsTheLargestRatioAndNaNBeforeAll) {
  auto found = norms(1, 2);
  found[1].ratio = 0.6;
  EXPECT_EQ(worst_of(found), 1U);
  found[0].ratio = std::nan("");
  EXPECT_EQ(worst_of(found), 0U);
  std::swap(found[0], found[1]);
  EXPECT_EQ(worst_of(found), 1U);
}

TEST_F(BlockNorms, DescriptionNamesTheLargestRowOnAllRanks) {
  auto residual = problem.guess(1);
  residual.replaceGlobalValue(9, -7.0);  // a row of the first block, on the last rank
  const auto found = block_norms(system(), residual, problem.guess(10), {}, 0);
  const std::string text =
      describe_block(system(), found[0], system().blocks[0], residual,
                     [](GlobalIndex row) { return "node " + std::to_string(row); });
  EXPECT_NE(text.find("block upper, field height: residual "), std::string::npos) << text;
  EXPECT_NE(text.find("largest at node 9"), std::string::npos) << text;
}

}  // namespace
}  // namespace hawser
