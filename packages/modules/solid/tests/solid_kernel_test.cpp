#include "solid_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "sample_cell.hpp"
#include "surface_load_kernel.hpp"

namespace hawser {
namespace {

constexpr ElasticLaw laws[] = {ElasticLaw::st_venant_kirchhoff, ElasticLaw::neo_hookean};
const std::vector<double> triangle = {0, 0, 4, 1, 1, 3};
const std::vector<double> quadrilateral = {0, 0, 4, 0.5, 2, 2, 0.2, 1.5};
const std::vector<double> tetrahedron = {0, 0, 0, 3, 0, 0.5, 0, 2, 0, 0.3, 0.2, 2};

SolidProperties rubber(ElasticLaw law) {
  SolidProperties solid;
  solid.law = law;
  solid.poisson = 0.4;
  solid.damping = 0.2;
  solid.viscosity = 30;
  return solid;
}

template <int D>
std::unique_ptr<SolidKernel<D>> kernel_of(ElasticLaw law, CellShape shape, Basis basis) {
  std::vector<double> force = {0.3, -9.81, 2};
  force.resize(D);
  auto kernel = std::make_unique<SolidKernel<D>>(
      "flag", rubber(law),
      std::vector<PropertyConstant>{std::vector<double>{1000}, std::vector<double>{1e4}, force});
  kernel->bind(tabulate_cell({basis, basis}, quadrature(shape, 4)));
  return kernel;
}

template <int D>
void check(ElasticLaw law, CellShape shape, Basis basis, const std::vector<double>& coordinates) {
  const auto kernel = kernel_of<D>(law, shape, basis);
  for (unsigned seed = 1; seed < 4; ++seed) {
    EXPECT_LE(worst_tangent_error(*kernel, coordinates, seed), 1e-6);
    const auto [power, sum] = SampleCell(*kernel, coordinates, seed).power();
    EXPECT_NEAR(sum / power, 1, 1e-10);
  }
}

TEST(SolidKernel, HasExactTangentsAndEnergyTermsForEveryLawShapeAndBasis) {
  for (const ElasticLaw law : laws)
    for (const Basis basis : {Basis::p1, Basis::p2}) {
      check<2>(law, CellShape::triangle, basis, triangle);
      check<2>(law, CellShape::quadrilateral, basis, quadrilateral);
      check<3>(law, CellShape::tetrahedron, basis, tetrahedron);
    }
}

TEST(SolidKernel, LoadsHaveExactTangentsAndPowers) {
  const SurfaceLoad load{{Expression("3*x + t"), Expression("x*y")}, {Expression("20 + y")}};
  SurfaceLoadKernel<2> kernel(Domain::facets("surface"), load);
  for (const Basis basis : {Basis::p1, Basis::p2}) {
    kernel.bind(tabulate_cell({basis, basis}, facet_quadrature(CellShape::triangle, 5)));
    for (unsigned seed = 1; seed < 4; ++seed) {
      EXPECT_LE(worst_tangent_error(kernel, triangle, seed), 1e-6);
      EXPECT_LE(worst_power_error(kernel, triangle, seed), 1e-6);
    }
  }
}

Tensor<double, 2> sheared(double x) {
  Tensor<double, 2> slope;
  slope(0, 0) = 0.2 * x, slope(0, 1) = 0.5 * x, slope(1, 0) = -0.1 * x, slope(1, 1) = 0.3 * x * x;
  return slope;
}

TEST(ElasticLaw, TheStressIsTheDerivativeOfTheEnergy) {
  const LameParameters<double> lame(1e4, 0.4);
  for (const ElasticLaw law : laws) {
    const Tensor<double, 2> strain = green_lagrange(sheared(1));
    const Tensor<double, 2> stress = second_piola(law, strain, lame);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        constexpr double step = 1e-6;
        Tensor<double, 2> plus = strain, minus = strain;
        // The energy knows symmetric strains only.
        plus(i, j) += step / 2, plus(j, i) += step / 2;
        minus(i, j) -= step / 2, minus(j, i) -= step / 2;
        const double slope =
            (strain_energy_density(law, plus, lame) - strain_energy_density(law, minus, lame)) /
            (2 * step);
        EXPECT_NEAR(slope, stress(i, j), 1e-5 * 1e4);
      }
  }
}

TEST(ElasticLaw, TheMeanStressDoesTheWorkThatTheEnergyGains) {
  const LameParameters<double> lame(1e4, 0.4);
  for (const ElasticLaw law : laws)
    for (const double far : {1.0, 0.3, 1e-3}) {
      const Tensor<double, 2> before = green_lagrange(sheared(0.5)),
                              after = green_lagrange(sheared(0.5 + far));
      const Tensor<double, 2> stress = mean_stress(law, before, after, lame);
      double work = 0;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          work += stress(i, j) * (after(i, j) - before(i, j));
      const double gain =
          strain_energy_density(law, after, lame) - strain_energy_density(law, before, lame);
      EXPECT_NEAR(work / gain, 1, 1e-10);
    }
}

TEST(ElasticLaw, SmallStrainsGiveHookesLawForBoth) {
  const LameParameters<double> lame(1e4, 0.4);
  const Tensor<double, 2> strain = green_lagrange(sheared(1e-6));
  const auto linear = second_piola(laws[0], strain, lame),
             other = second_piola(laws[1], strain, lame);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      EXPECT_NEAR(other(i, j), linear(i, j), 1e-5 * std::abs(linear(0, 0)));
}

TEST(SolidKernel, CauchyStressOfAnInflatedCell) {
  // x = (1 + s) X: C = (1 + s)^2 I, S = (lambda tr E + 2 mu E) I, sigma = F S F^T / J = S.
  const auto kernel = kernel_of<2>(laws[0], CellShape::triangle, Basis::p1);
  const double s = 0.1, strain = s + 0.5 * s * s;
  std::vector<double> displacement, zero(6, 0);
  for (const double x : triangle)
    displacement.push_back(s * x);
  const FieldOnCell fields[] = {
      {zero.data(), zero.data(), zero.data(), zero.data(), zero.data()},
      {displacement.data(), zero.data(), zero.data(), zero.data(), zero.data()}};
  const CellInput cell{0, 0.1, triangle.data(), fields};
  double stress[3];
  kernel->evaluate(cell, stress);
  const LameParameters<double> lame(1e4, 0.4);
  const double expected = 2 * (lame.first + lame.shear) * strain;
  EXPECT_NEAR(stress[0], expected, 1e-9 * expected);
  EXPECT_NEAR(stress[1], expected, 1e-9 * expected);
  EXPECT_NEAR(stress[2], 0, 1e-9 * expected);
}

}  // namespace
}  // namespace hawser
