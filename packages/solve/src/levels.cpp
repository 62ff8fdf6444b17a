#include "levels.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include "hawser/base/error.hpp"
#include "with_ghosts.hpp"

namespace hawser {
namespace {

/// 1 on the field's unknowns, ghosts included, else 0.
TpetraVector ones_on(const BlockSystem& system, const std::string& field) {
  TpetraVector owned(system.rows);
  for (const Block& block : system.blocks)
    if (block.field == field)
      for (const LocalIndex row : block.rows)
        owned.replaceLocalValue(row, 1.0);
  TpetraVector all(system.matrix->getColMap());
  with_ghosts(*system.matrix, owned, all);
  return all;
}

struct Fit {
  double rise = 0;   ///< of the level
  double taken = 0;  ///< share of the squared residual that it takes away
};

Fit fit_level(const BlockSystem& system, const TpetraVector& f, const std::string& field) {
  constexpr double rounding = 1e-10;  // of a row's entries that cancel
  const TpetraVector ones = ones_on(system, field);
  const auto level = ones.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto residual = f.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto local = system.matrix->getLocalMatrixHost();
  double sums[4] = {0, 0, 0, 0};  // f.g, g.g, f.f with g = J 1, rows scaled; unknowns of the field
  for (const Block& block : system.blocks)
    if (block.field == field) sums[3] += static_cast<double>(block.rows.size());
  for (LocalIndex row = 0; row < local.numRows(); ++row) {
    double largest = 0, sum = 0, absolute = 0;
    for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
      const double entry = local.values(k);
      largest = std::max(largest, std::abs(entry));
      sum += entry * level(local.graph.entries(k), 0);
      absolute += std::abs(entry) * level(local.graph.entries(k), 0);
    }
    if (largest == 0) continue;
    const double g = std::abs(sum) > rounding * absolute ? sum / largest : 0;
    const double off = residual(row, 0) / largest;
    sums[0] += off * g;
    sums[1] += g * g;
    sums[2] += off * off;
  }
  MPI_Allreduce(MPI_IN_PLACE, sums, 4, MPI_DOUBLE, MPI_SUM, system.communicator.mpi());
  if (sums[1] == 0 && sums[3] > 0)
    throw SolveError(
        "nothing holds the level of the field '" + field +
        "': a constant added to it everywhere changes no equation; prescribe it at one "
        "point, <prescribe field=\"" +
        field + "\" on=\"corner\" value=\"0\"/>, or open a boundary, <outflow>");
  if (!(sums[1] > 0) || !(sums[2] > 0)) return {};
  return {-sums[0] / sums[1], sums[0] * sums[0] / (sums[1] * sums[2])};
}

}  // namespace

bool level_fields(const BlockSystem& system, const TpetraVector& f, TpetraVector& rise) {
  constexpr double good_part = 0.5;
  bool found = false;
  for (std::size_t i = 0; i < system.blocks.size(); ++i) {
    const std::string& field = system.blocks[i].field;
    const auto same = [&](const Block& block) { return block.field == field; };
    if (!system.blocks[i].has_level ||
        std::any_of(system.blocks.begin(), system.blocks.begin() + static_cast<long>(i), same))
      continue;
    const Fit fit = fit_level(system, f, field);
    if (!(fit.taken > good_part)) continue;
    found = true;
    for (const Block& block : system.blocks)
      if (same(block))
        for (const LocalIndex row : block.rows)
          rise.sumIntoLocalValue(row, fit.rise);
  }
  return found;
}

}  // namespace hawser
