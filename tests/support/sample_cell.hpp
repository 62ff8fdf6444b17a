#pragma once
// What every kernel's tangent and energy terms must obey, on a sample cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hawser/physics/sample_cell.hpp"

namespace hawser {

/// The terms of the energy balance are the power of the residual, and those stored the rate of what
/// is stored: the worst relative error.
inline double worst_power_error(const Kernel& kernel, const std::vector<double>& coordinates,
                                unsigned seed) {
  SampleCell cell(kernel, coordinates, seed);
  const auto [power, sum] = cell.power();
  double worst = std::abs(sum - power) / std::abs(power);
  const double time = 1e-5;  // s
  const auto terms = cell.powers(), after = cell.energies_after(time),
             before = cell.energies_after(-time);
  for (std::size_t i = 0; i < terms.size(); ++i)
    if (kernel.energy_terms()[i].kind == EnergyTerm::Kind::stored)
      worst = std::max(worst, std::abs((after[i] - before[i]) / (2 * time * terms[i]) - 1));
  return worst;
}

/// Compares the tangent with central differences of the residual, per pair of fields; returns the
/// worst relative difference of a block. The residual must come out the same both ways.
inline double worst_tangent_error(const Kernel& kernel, const std::vector<double>& coordinates,
                                  unsigned seed) {
  SampleCell cell(kernel, coordinates, seed);
  std::vector<double> alone, residual, tangent;
  EXPECT_EQ(cell.residual(-1, 0, alone), CellStatus::ok);
  EXPECT_EQ(cell.tangent(residual, tangent), CellStatus::ok);
  double scale = 0, worst = 0;
  for (const double entry : alone)
    scale = std::max(scale, std::abs(entry));
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(residual[i], alone[i], 1e-13 * scale);  // formulas with slopes round differently

  const auto blocks = compare_tangent(cell);
  if (!blocks) {
    ADD_FAILURE() << "no admissible state on " << kernel.domain().text() << ", seed " << seed;
    return std::numeric_limits<double>::infinity();
  }
  for (const TangentBlock& block : *blocks) {
    worst = std::max(worst, block.error);
    EXPECT_LE(block.error, 1e-6) << "block (" << kernel.fields()[block.row].name << ", "
                                 << kernel.fields()[block.column].name << ") on "
                                 << kernel.domain().text() << ", seed " << seed;
  }
  return worst;
}

}  // namespace hawser
