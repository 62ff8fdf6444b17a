#include "hawser/base/tensor.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace hawser {
namespace {

/// A number that knows its derivative, as far as products need it.
struct Dual {
  double value = 0, slope = 0;
  Dual& operator+=(const Dual& b) {
    value += b.value;
    slope += b.slope;
    return *this;
  }
};
Dual operator*(const Dual& a, double b) { return {a.value * b, a.slope * b}; }
Dual operator*(double a, const Dual& b) { return b * a; }

Tensor<double, 3> sample() {
  Tensor<double, 3> a;
  const double entries[] = {2, -1, 0.5, 0, 3, 1, 4, 1, -2};
  for (int k = 0; k < 9; ++k)
    a(k / 3, k % 3) = entries[k];
  return a;
}

TEST(Tensor, TheAdjugateIsTheInverseTimesTheDeterminant) {
  const auto a = sample();
  const auto product = multiply(a, adjugate(a));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(product(i, j), i == j ? determinant(a) : 0, 1e-13);
  EXPECT_EQ(trace(a), 3);
}

TEST(Tensor, ProductsTakeTheTypeThatCarriesDerivatives) {
  Tensor<Dual, 3> x;
  x(1, 2) = {5, 1};
  const auto left = multiply(sample(), x), right = multiply(x, sample());
  static_assert(std::is_same_v<decltype(left), const Tensor<Dual, 3>>);
  static_assert(std::is_same_v<decltype(right), const Tensor<Dual, 3>>);
  EXPECT_EQ(left(1, 2).slope, 3);
  EXPECT_EQ(right(1, 0).slope, 4);
  Vector<Dual, 3> v;
  v[0] = {2, 1};
  EXPECT_EQ(multiply(sample(), v)[2].value, 8);
  EXPECT_EQ(multiply(v, sample())[1].slope, -1);
  EXPECT_EQ(dot(Vector<double, 3>{{7, 0, 0}}, v).slope, 7);
}

}  // namespace
}  // namespace hawser
