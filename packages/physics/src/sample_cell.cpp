#include "hawser/physics/sample_cell.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

/// [row][column]; nothing when a state is not admissible.
std::optional<std::vector<double>> central_differences(SampleCell& cell) {
  const int n = cell.unknowns();
  std::vector<double> result(static_cast<std::size_t>(n * n)), plus, minus;
  for (int j = 0; j < n; ++j) {
    const double shift = 1e-5 * cell.amplitude(j);
    if (cell.residual(j, shift, plus) != CellStatus::ok ||
        cell.residual(j, -shift, minus) != CellStatus::ok)
      return std::nullopt;
    for (int i = 0; i < n; ++i)
      result[static_cast<std::size_t>(i * n + j)] =
          (plus[static_cast<std::size_t>(i)] - minus[static_cast<std::size_t>(i)]) / (2 * shift);
  }
  return result;
}

TangentBlock compare(const SampleCell& cell, std::size_t row, std::size_t column,
                     const std::vector<double>& tangent, const std::vector<double>& differences) {
  TangentBlock block{row, column, 0, 0, 0};
  double size = 0, worst = -1;
  for (int i = cell.first(row); i < cell.first(row + 1); ++i)
    for (int j = cell.first(column); j < cell.first(column + 1); ++j) {
      const auto k = static_cast<std::size_t>(i * cell.unknowns() + j);
      size = std::max({size, std::abs(tangent[k]), std::abs(differences[k])});
      const double error = std::abs(tangent[k] - differences[k]);
      if (error <= worst) continue;
      worst = error;
      block.tangent = tangent[k];
      block.difference = differences[k];
    }
  block.error = size > 0 ? worst / size : 0;
  return block;
}

}  // namespace

std::vector<double> sample_amplitudes(const Kernel& kernel) {
  std::vector<double> amplitudes = kernel.sample_amplitudes();
  const std::vector<FieldUse>& fields = kernel.fields();
  if (amplitudes.size() > fields.size())
    throw PluginError("a kernel on '" + kernel.domain().text() + "' has " +
                      std::to_string(amplitudes.size()) + " sample_amplitudes() for " +
                      std::to_string(fields.size()) + " fields");
  for (std::size_t f = amplitudes.size(); f < fields.size(); ++f)
    amplitudes.push_back(fields[f].places_nodes ? 0.05 : 10);
  return amplitudes;
}

std::optional<std::vector<TangentBlock>> compare_tangent(SampleCell& cell) {
  std::vector<double> residual, tangent;
  if (cell.tangent(residual, tangent) != CellStatus::ok) return std::nullopt;
  const auto differences = central_differences(cell);
  if (!differences) return std::nullopt;
  std::vector<TangentBlock> blocks;
  const std::size_t fields = cell.kernel().fields().size();
  for (std::size_t row = 0; row < fields; ++row)
    for (std::size_t column = 0; column < fields; ++column) {
      const TangentBlock block = compare(cell, row, column, tangent, *differences);
      if (block.tangent != 0 || block.difference != 0) blocks.push_back(block);
    }
  return blocks;
}

}  // namespace hawser
