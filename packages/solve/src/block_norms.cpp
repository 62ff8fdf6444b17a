#include "block_norms.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hawser {
namespace {

/// Sums over all ranks at once, then takes the square roots.
void reduce_norms(const BlockSystem& system, std::vector<double>& squares) {
  MPI_Allreduce(MPI_IN_PLACE, squares.data(), static_cast<int>(squares.size()), MPI_DOUBLE, MPI_SUM,
                system.communicator.mpi());
  for (double& value : squares)
    value = std::sqrt(value);
}

}  // namespace

JacobianScales jacobian_scales(const BlockSystem& system, const TpetraVector& x) {
  const auto& matrix = *system.matrix;
  TpetraVector with_ghosts(matrix.getColMap());
  const auto importer = matrix.getGraph()->getImporter();
  if (importer.is_null())
    with_ghosts.update(1.0, x, 0.0);
  else
    with_ghosts.doImport(x, *importer, Tpetra::INSERT);
  const auto values = with_ghosts.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto local = matrix.getLocalMatrixHost();
  JacobianScales scales{std::vector<double>(static_cast<std::size_t>(local.numRows()), 0.0),
                        std::vector<double>(system.blocks.size(), 0.0)};
  for (std::size_t i = 0; i < system.blocks.size(); ++i) {
    const Block& block = system.blocks[i];
    for (const LocalIndex row : block.rows) {
      double product = 0, largest = 0, own = 0;
      for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
        const double entry = std::abs(local.values(k));
        product += entry * std::abs(values(local.graph.entries(k), 0));
        largest = std::max(largest, entry);
        if (local.graph.entries(k) == row) own = entry;  // columns: the rows, then the ghosts
      }
      if (own == 0) own = largest;
      scales.of_unknown[static_cast<std::size_t>(row)] = own;
      if (!block.sizes.empty() && own > 0) product /= own;
      scales.products[i] += product * product;
    }
  }
  reduce_norms(system, scales.products);
  return scales;
}

std::vector<BlockNorm> block_norms(const BlockSystem& system, const TpetraVector& residual,
                                   const TpetraVector& magnitude, const JacobianScales& scales,
                                   double round_off) {
  const auto f = residual.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto m = magnitude.getLocalViewHost(Tpetra::Access::ReadOnly);
  std::vector<double> sums(2 * system.blocks.size(), 0.0);
  for (std::size_t i = 0; i < system.blocks.size(); ++i) {
    const Block& block = system.blocks[i];
    const bool sized = !block.sizes.empty() && !scales.of_unknown.empty();
    for (std::size_t k = 0; k < block.rows.size(); ++k) {
      const LocalIndex row = block.rows[k];
      double off = f(row, 0), whole = m(row, 0);
      if (sized) {
        const double slope = scales.of_unknown[static_cast<std::size_t>(row)];
        if (slope > 0) off /= slope;
        whole = block.sizes[k];
      }
      sums[2 * i] += off * off;
      sums[2 * i + 1] += whole * whole;
    }
  }
  reduce_norms(system, sums);
  std::vector<BlockNorm> norms;
  for (std::size_t i = 0; i < system.blocks.size(); ++i) {
    const auto& block = system.blocks[i];
    BlockNorm norm{block.name, block.field, block.unit, sums[2 * i], sums[2 * i + 1], 0.0};
    const double none = scales.products.empty() ? 0 : round_off * scales.products[i];
    if (!(norm.residual <= none)) norm.ratio = norm.residual / norm.magnitude;
    norms.push_back(norm);
  }
  return norms;
}

std::vector<double> relative_changes(const BlockSystem& system, const TpetraVector& change,
                                     const TpetraVector& x) {
  const auto& blocks = system.blocks;
  const auto values = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto changes = change.getLocalViewHost(Tpetra::Access::ReadOnly);
  // Per block the unknowns' count and the sums of their values and changes; then of their squares.
  std::vector<double> sums(3 * blocks.size(), 0.0), squares(2 * blocks.size(), 0.0);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (const LocalIndex row : blocks[i].rows) {
      sums[3 * i] += 1;
      sums[3 * i + 1] += values(row, 0);
      sums[3 * i + 2] += changes(row, 0);
    }
  const auto add_ranks = [&](std::vector<double>& numbers) {
    MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE,
                  MPI_SUM, system.communicator.mpi());
  };
  const auto over_field = [&](std::size_t block, const std::vector<double>& numbers,
                              std::size_t width, std::size_t which) {
    double sum = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i)
      if (blocks[i].field == blocks[block].field) sum += numbers[width * i + which];
    return sum;
  };
  add_ranks(sums);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const double count = blocks[i].has_level ? over_field(i, sums, 3, 0) : 0;
    const double level = count > 0 ? over_field(i, sums, 3, 1) / count : 0;
    const double rise = count > 0 ? over_field(i, sums, 3, 2) / count : 0;
    for (std::size_t k = 0; k < blocks[i].rows.size(); ++k) {
      const LocalIndex row = blocks[i].rows[k];
      const double size = blocks[i].sizes.empty() ? values(row, 0) - level : blocks[i].sizes[k];
      const double off = changes(row, 0) - rise;
      squares[2 * i] += size * size;
      squares[2 * i + 1] += off * off;
    }
  }
  add_ranks(squares);
  std::vector<double> result;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const double of_field = over_field(i, squares, 2, 0) / over_field(i, sums, 3, 0);
    const double size = std::max(squares[2 * i], sums[3 * i] * of_field);
    result.push_back(squares[2 * i + 1] == 0 ? 0 : std::sqrt(squares[2 * i + 1] / size));
  }
  return result;
}

std::size_t worst_of(const std::vector<BlockNorm>& norms) {
  std::size_t worst = 0;
  for (std::size_t i = 1; i < norms.size(); ++i)
    if (!(norms[i].ratio <= norms[worst].ratio) && !std::isnan(norms[worst].ratio)) worst = i;
  return worst;
}

std::string describe_block(const BlockSystem& system, const BlockNorm& norm, const Block& block,
                           const TpetraVector& residual,
                           const std::function<std::string(GlobalIndex)>& describe_row) {
  const auto f = residual.getLocalViewHost(Tpetra::Access::ReadOnly);
  struct {
    double size = -1;
    int rank = 0;
  } largest;
  LocalIndex row = 0;
  for (const LocalIndex candidate : block.rows) {
    double size = std::abs(f(candidate, 0));
    if (!std::isfinite(size)) size = HUGE_VAL;  // a NaN would get lost in the comparison of ranks
    if (size <= largest.size) continue;
    largest.size = size;
    row = candidate;
  }
  const auto& communicator = system.communicator;
  largest.rank = communicator.rank();
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, communicator.mpi());

  std::string where;
  if (communicator.rank() == largest.rank && largest.size >= 0) {
    const GlobalIndex number = system.rows->getGlobalElement(row);
    where = describe_row ? describe_row(number) : "row " + std::to_string(number);
  }
  auto length = static_cast<int>(where.size());
  MPI_Bcast(&length, 1, MPI_INT, largest.rank, communicator.mpi());
  where.resize(static_cast<std::size_t>(length));
  MPI_Bcast(where.data(), length, MPI_CHAR, largest.rank, communicator.mpi());

  char numbers[96];
  std::snprintf(numbers, sizeof numbers, "residual %.2e %s, %.2e of its magnitude", norm.residual,
                norm.unit.c_str(), norm.ratio);
  return "block " + norm.block + ", field " + norm.field + ": " + numbers + ", largest at " + where;
}

}  // namespace hawser
