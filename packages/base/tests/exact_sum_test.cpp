#include "hawser/base/exact_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

/// Terms of very different size and both signs, those of each rank in an order of its own.
std::vector<double> mine(const Communicator& world, int count, double scale) {
  std::vector<double> terms;
  for (int i = world.rank(); i < count; i += world.size())
    terms.push_back(scale * std::sin(i + 0.3) * std::pow(10, i % 7 - 3));
  if (world.rank() % 2 == 0) std::reverse(terms.begin(), terms.end());
  return terms;
}

TEST(ExactSum, IsTheSameOnAnyNumberOfRanks) {
  const Communicator world, self(MPI_COMM_SELF);
  for (const double scale : {1.0, -1e-200, 1e200})
    EXPECT_EQ(exact_sum(world, mine(world, 1001, scale)), exact_sum(self, mine(self, 1001, scale)));
}

TEST(ExactSum, LosesNothingWhereLargeTermsCancel) {
  const Communicator world;
  std::vector<double> terms;
  if (world.is_root()) terms = {1e10, 1, -1e10, 1e-12};
  EXPECT_EQ(exact_sum(world, terms), 1 + 1e-12);
  for (double& term : terms)
    term = -term;
  EXPECT_EQ(exact_sum(world, terms), -1 - 1e-12);
  EXPECT_EQ(exact_sum(world, {}), 0);
  EXPECT_EQ(exact_sum(Communicator(MPI_COMM_SELF), {0.1}), 0.1);
}

TEST(ExactSum, OfSomethingThatIsNotFiniteIsNoNumber) {
  const Communicator world;
  EXPECT_TRUE(std::isnan(exact_sum(world, {world.is_root() ? std::nan("") : 1.0})));
}

}  // namespace
}  // namespace hawser
