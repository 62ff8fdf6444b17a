#include "fluid_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "outflow_kernel.hpp"
#include "sample_cell.hpp"
#include "taylor_hood_kernel.hpp"

namespace hawser {
namespace {

const std::vector<double> triangle = {0, 0, 4, 1, 1, 3};
const std::vector<double> quadrilateral = {0, 0, 4, 0.5, 2, 2, 0.2, 1.5};
const std::vector<double> tetrahedron = {0, 0, 0, 3, 0, 0.5, 0, 2, 0, 0.3, 0.2, 2};

template <int D>
std::vector<PropertyConstant> water(std::vector<double> force) {
  force.resize(D);
  return {std::vector<double>{1000}, std::vector<double>{300}, std::nullopt, std::move(force)};
}

template <int D>
double worst_error(CellShape shape, const std::vector<double>& coordinates) {
  FluidKernel<D> kernel("water", water<D>({0.3, -9.81}));
  kernel.bind(tabulate_cell({Basis::p1, Basis::p1, Basis::p1}, quadrature(shape, 3)));
  double worst = 0;
  for (unsigned seed = 1; seed < 4; ++seed)
    worst = std::max(worst, worst_tangent_error(kernel, coordinates, seed));
  return worst;
}

TEST(FluidKernel, TangentIsTheDerivativeOnEveryShape) {
  EXPECT_LE(worst_error<2>(CellShape::triangle, triangle), 1e-6);
  EXPECT_LE(worst_error<2>(CellShape::quadrilateral, quadrilateral), 1e-6);
  EXPECT_LE(worst_error<3>(CellShape::tetrahedron, tetrahedron), 1e-6);
}

template <int D>
double worst_error_of_taylor_hood(CellShape shape, const std::vector<double>& coordinates) {
  TaylorHoodKernel<D> kernel("water", water<D>({0.3, -9.81}), 2);
  kernel.bind(tabulate_cell({Basis::p2, Basis::p1, Basis::p2}, quadrature(shape, 5)));
  double worst = 0;
  for (unsigned seed = 1; seed < 4; ++seed)
    worst = std::max({worst, worst_tangent_error(kernel, coordinates, seed),
                      worst_power_error(kernel, coordinates, seed)});
  return worst;
}

TEST(TaylorHoodKernel, HasExactTangentsAndEnergyTermsOnEveryShape) {
  EXPECT_LE(worst_error_of_taylor_hood<2>(CellShape::triangle, triangle), 1e-6);
  EXPECT_LE(worst_error_of_taylor_hood<2>(CellShape::quadrilateral, quadrilateral), 1e-6);
  EXPECT_LE(worst_error_of_taylor_hood<3>(CellShape::tetrahedron, tetrahedron), 1e-6);
}

TEST(FluidKernel, EnergyTermsAreThePowerOfTheResidual) {
  for (const auto& [shape, coordinates] :
       {std::pair{CellShape::triangle, triangle}, {CellShape::quadrilateral, quadrilateral}}) {
    FluidKernel<2> kernel("water", water<2>({0.3, -9.81}));
    kernel.bind(tabulate_cell({Basis::p1, Basis::p1, Basis::p1}, quadrature(shape, 3)));
    for (unsigned seed = 1; seed < 6; ++seed)
      EXPECT_LE(worst_power_error(kernel, coordinates, seed), 1e-7);
  }
}

TEST(OutflowKernel, CarriesOffThePowerOfItsResidual) {
  OutflowKernel<2> kernel(Domain::facets("outlet"),
                          {std::vector<double>{1000}, std::vector<double>{300}, std::nullopt},
                          {2e4, true, 0.5});
  kernel.bind(tabulate_cell({Basis::p2, Basis::p2}, facet_quadrature(CellShape::triangle, 5)));
  for (unsigned seed = 1; seed < 6; ++seed)
    EXPECT_LE(worst_power_error(kernel, triangle, seed), 1e-12);
}

// Water at rest under its own weight, p = -rho g y: nothing but the boundary's share of p remains,
// which the shapes of a cell cancel among each other.
TEST(FluidKernel, HydrostaticWaterIsInBalance) {
  FluidKernel<2> kernel("water", water<2>({0, -9.81}));
  kernel.bind(tabulate_cell({Basis::p1, Basis::p1, Basis::p1}, quadrature(CellShape::triangle, 2)));
  const std::vector<double> zero(6, 0);
  std::vector<double> pressure;
  for (std::size_t a = 0; a < 3; ++a)
    pressure.push_back(-9810 * triangle[2 * a + 1]);
  std::vector<FieldOnCell> fields;
  for (const double* values :
       std::initializer_list<const double*>{zero.data(), pressure.data(), zero.data()})
    fields.push_back({values, zero.data(), zero.data(), zero.data(), zero.data()});
  const CellInput cell{0, 0.1, triangle.data(), fields.data(), zero.data(), 0.1};
  double residual[15];
  ASSERT_EQ(kernel.residual(cell, residual), CellStatus::ok);
  for (int a = 0; a < 3; ++a)
    EXPECT_NEAR(residual[6 + a], 0, 1e-9) << "continuity: no strong residual, no flow";
  // The weight of the water is what all nodes carry together.
  const double area = 5.5;
  EXPECT_NEAR(residual[1] + residual[3] + residual[5], 1000 * 9.81 * area, 1e-7);
  EXPECT_NEAR(residual[0] + residual[2] + residual[4], 0, 1e-7);
}

// Turning the numbering of a cell's vertices turns the residual and changes nothing else: the
// stabilisation's metric is that of the regular cell.
TEST(FluidKernel, TheNumberingOfVerticesDoesNotMatter) {
  FluidKernel<2> kernel("water", water<2>({0.3, -9.81}));
  kernel.bind(tabulate_cell({Basis::p1, Basis::p1, Basis::p1}, quadrature(CellShape::triangle, 2)));
  const std::vector<double> velocity = {0.1, -0.5, 0.2, -0.4, 0, -0.45}, pressure = {10, 20, -5};
  const auto residual = [&](std::size_t turn) {
    std::vector<double> X, v, p;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t from = (a + turn) % 3;
      for (std::size_t j = 0; j < 2; ++j) {
        X.push_back(triangle[2 * from + j]);
        v.push_back(velocity[2 * from + j]);
      }
      p.push_back(pressure[from]);
    }
    const std::vector<double> zero(6, 0);
    std::vector<FieldOnCell> fields;
    for (const double* values :
         std::initializer_list<const double*>{v.data(), p.data(), zero.data()})
      fields.push_back({values, zero.data(), zero.data(), zero.data(), zero.data()});
    const CellInput cell{0, 0.1, X.data(), fields.data(), zero.data(), 0.1};
    std::vector<double> result(15);
    EXPECT_EQ(kernel.residual(cell, result.data()), CellStatus::ok);
    return result;
  };
  const auto first = residual(0), second = residual(1);
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t from = (a + 1) % 3;
    for (std::size_t j = 0; j < 2; ++j)
      EXPECT_NEAR(second[2 * a + j], first[2 * from + j], 1e-8);
    EXPECT_NEAR(second[6 + a], first[6 + from], 1e-11);
  }
}

/// Water at rest on one cell under a pressure gradient of 3 Pa/m along x: the strong residual.
struct PushedWater {
  FluidKernel<2> kernel{"water", water<2>({0, 0})};
  std::vector<double> zero = std::vector<double>(6, 0), pressure = {0, 12, 3}, memory = zero;
  std::vector<FieldOnCell> fields;

  PushedWater() {
    kernel.bind(
        tabulate_cell({Basis::p1, Basis::p1, Basis::p1}, quadrature(CellShape::triangle, 2)));
    for (const double* values : {zero.data(), pressure.data(), zero.data()})
      fields.push_back({values, zero.data(), zero.data(), zero.data(), zero.data()});
  }
  /// The subscale along x at the first point, `elapsed` s later.
  double advance(double elapsed) {
    std::vector<double> next(6);
    kernel.advance_memory({0, elapsed, triangle.data(), fields.data(), memory.data(), elapsed},
                          next.data());
    memory = next;
    return next[0];
  }
};

// rho dv'/dt + rho v'/tau = -grad p.
TEST(FluidKernel, TheSubscaleFollowsItsOwnEquation) {
  ASSERT_EQ(PushedWater().kernel.memory_per_cell(), 6);
  const double steady = PushedWater().advance(std::numeric_limits<double>::infinity());
  const double tau = -steady / (3.0 / 1000);
  EXPECT_GT(tau, 0);
  const double brief = 1e-6 * tau;
  EXPECT_NEAR(PushedWater().advance(brief), -brief * 3 / 1000, 1e-5 * brief);
  for (const double step : {0.1 * tau, tau, 10 * tau}) {  // the same limit at any step
    PushedWater water;
    double subscale = 0;
    for (int n = 1; n <= 400; ++n)
      subscale = water.advance(step);
    EXPECT_NEAR(subscale, steady, 1e-12 * tau);
  }
  PushedWater water;
  double subscale = 0;
  for (int n = 0; n < 1000; ++n)
    subscale = water.advance(tau / 1000);
  EXPECT_NEAR(subscale, steady * (1 - std::exp(-1.0)), -1e-3 * steady);
}

}  // namespace
}  // namespace hawser
