#include "patch.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Vector.hpp>

#include "with_ghosts.hpp"

namespace hawser {
namespace {

/// Marks the rows that share an entry with a marked one.
void grow(const TpetraMatrix& matrix, std::vector<char>& marked) {
  const std::vector<GlobalIndex> near =
      spread(matrix, std::vector<GlobalIndex>(marked.begin(), marked.end()));
  const auto local = matrix.getLocalMatrixHost();
  for (LocalIndex row = 0; row < local.numRows(); ++row)
    for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k)
      if (near[static_cast<std::size_t>(local.graph.entries(k))] != 0)
        marked[static_cast<std::size_t>(row)] = 1;
}

}  // namespace

Patch::Patch(const Communicator& communicator, const Teuchos::RCP<const TpetraMatrix>& matrix,
             std::vector<char> seeds, bool repeatable)
    : matrix_(matrix) {
  for (int layer = 0; layer < layers; ++layer)
    grow(*matrix, seeds);
  std::vector<LocalIndex> rows;
  for (std::size_t row = 0; row < seeds.size(); ++row)
    if (seeds[row] != 0) rows.push_back(static_cast<LocalIndex>(row));
  rows_ = communicator.sum(static_cast<long long>(rows.size()));
  if (rows_ == 0 || 2 * rows_ > static_cast<long long>(matrix->getGlobalNumRows())) return;

  const auto map = consecutive(*matrix->getRowMap(), rows.size());
  std::vector<GlobalIndex> numbers(seeds.size(), SubMatrix::absent);
  for (std::size_t i = 0; i < rows.size(); ++i)
    numbers[static_cast<std::size_t>(rows[i])] = map->getGlobalElement(static_cast<LocalIndex>(i));
  part_ = std::make_unique<SubMatrix>(*matrix, std::move(rows), map, spread(*matrix, numbers));
  factor_ = std::make_unique<MumpsFactor>(communicator, repeatable);
  factor_->symbolic(part_->matrix());
  residual_ = Teuchos::rcp(new TpetraVector(map));
  change_ = Teuchos::rcp(new TpetraVector(map));
  near_ = Teuchos::rcp(new TpetraVector(matrix->getColMap()));
}

void Patch::numeric() {
  part_->take(*matrix_);
  factor_->numeric();
}

void Patch::correct(const TpetraVector& b, TpetraVector& y) const {
  with_ghosts(*matrix_, y, *near_);
  {
    const auto local = matrix_->getLocalMatrixHost();
    const auto right = b.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto values = near_->getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto residual = residual_->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < part_->rows().size(); ++i) {
      const LocalIndex row = part_->rows()[i];
      double rest = right(row, 0);
      for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k)
        rest -= local.values(k) * values(local.graph.entries(k), 0);
      residual(i, 0) = rest;
    }
  }
  factor_->solve(*residual_, *change_);
  const auto change = change_->getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto corrected = y.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (std::size_t i = 0; i < part_->rows().size(); ++i)
    corrected(part_->rows()[i], 0) += change(i, 0);
}

}  // namespace hawser
