#include "src/row_scaling.hpp"

#include <gtest/gtest.h>

#include "pointwise_problem.hpp"

namespace hawser {
namespace {

using test::PointwiseProblem;

/// A diagonal matrix of x -> x^3 at x.
PointwiseProblem cubes(double x) {
  PointwiseProblem problem([](double) { return 0; }, [](double at) { return at * at * at; });
  problem.jacobian(problem.guess(x));
  return problem;
}

TEST(RowScaling, TakesTheLargestEntryToOneByAPowerOfTwo) {
  for (const double x : {-3.0, 1e-5, 1.0, 7e8}) {
    auto problem = cubes(x);
    const auto& matrix = problem.system().matrix;
    RowScaling scaling;
    scaling.compute(*matrix, problem.system().communicator);
    TpetraVector factors(problem.system().rows);
    scaling.apply(problem.guess(1.0), factors);
    const auto values = factors.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t row = 0; row < factors.getLocalLength(); ++row) {
      int exponent = 0;
      EXPECT_EQ(std::frexp(values(row, 0), &exponent), 0.5);  // a power of two
      EXPECT_GE(std::abs(x * x * x) * values(row, 0), 1);
      EXPECT_LT(std::abs(x * x * x) * values(row, 0), 2);
    }
    TpetraMatrix scaled(matrix->getCrsGraph());
    scaled.fillComplete(problem.system().rows, problem.system().rows);
    scaling.apply(*matrix, scaled);
    TpetraVector product(problem.system().rows);
    scaled.apply(problem.guess(1.0), product);
    factors.scale(x * x * x);
    product.update(-1.0, factors, 1.0);
    EXPECT_EQ(product.normInf(), 0);  // nothing is rounded
  }
}

TEST(RowScaling, RefusesARowOfZerosAndWhatIsNotFinite) {
  const auto error_of = [](double x) -> std::string {
    auto problem = cubes(x);
    try {
      RowScaling().compute(*problem.system().matrix, problem.system().communicator);
    } catch (const SolveError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(error_of(0).find("is zero, so the matrix is singular"), std::string::npos);
  EXPECT_NE(error_of(std::nan("")).find("not finite"), std::string::npos);
  EXPECT_NE(error_of(1e200).find("not finite"), std::string::npos);
}

}  // namespace
}  // namespace hawser
