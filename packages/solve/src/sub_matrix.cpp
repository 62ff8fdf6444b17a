#include "sub_matrix.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>

namespace hawser {

std::vector<GlobalIndex> spread(const TpetraMatrix& matrix, const std::vector<GlobalIndex>& rows) {
  using Numbers = Tpetra::Vector<GlobalIndex>;
  Numbers owned(matrix.getRowMap());
  for (std::size_t row = 0; row < rows.size(); ++row)
    owned.replaceLocalValue(static_cast<LocalIndex>(row), rows[row]);
  Numbers all(matrix.getColMap());
  all.doImport(owned, Tpetra::Import<>(matrix.getRowMap(), matrix.getColMap()), Tpetra::INSERT);
  const auto view = all.getData();
  return {view.begin(), view.end()};
}

Teuchos::RCP<const TpetraMap> consecutive(const TpetraMap& like, std::size_t mine) {
  const auto unknown = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return Teuchos::rcp(new TpetraMap(unknown, mine, 0, like.getComm()));
}

SubMatrix::SubMatrix(const TpetraMatrix& source, std::vector<LocalIndex> rows,
                     const Teuchos::RCP<const TpetraMap>& map,
                     const std::vector<GlobalIndex>& columns)
    : rows_(std::move(rows)) {
  const auto from = source.getLocalMatrixHost();
  const auto each_target = [&](std::size_t i, auto&& visit) {
    if (rows_[i] == identity) return;
    for (auto k = from.graph.row_map(rows_[i]); k < from.graph.row_map(rows_[i] + 1); ++k)
      visit(columns[static_cast<std::size_t>(from.graph.entries(k))]);
  };
  std::vector<std::vector<GlobalIndex>> kept(rows_.size());
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    auto& mine = kept[i];
    mine.push_back(map->getGlobalElement(static_cast<LocalIndex>(i)));
    each_target(i, [&](GlobalIndex column) {
      if (column != absent) mine.push_back(column);
    });
    std::sort(mine.begin(), mine.end());
    mine.erase(std::unique(mine.begin(), mine.end()), mine.end());
    sizes.push_back(mine.size());
  }
  const auto graph = Teuchos::rcp(
      new Tpetra::CrsGraph<>(map, Teuchos::ArrayView<const std::size_t>(
                                      sizes.data(), static_cast<Teuchos::Ordinal>(sizes.size()))));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    graph->insertGlobalIndices(map->getGlobalElement(static_cast<LocalIndex>(i)), kept[i]);
    kept[i] = {};
  }
  graph->fillComplete(map, map);
  matrix_ = Teuchos::rcp(new TpetraMatrix(graph));
  matrix_->fillComplete(map, map);

  const auto to = matrix_->getLocalMatrixHost();
  const auto& numbers = *matrix_->getColMap();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto row = static_cast<LocalIndex>(i);
    const auto* const begin = &to.graph.entries(to.graph.row_map(row));
    const auto* const end = begin + (to.graph.row_map(row + 1) - to.graph.row_map(row));
    const auto place = [&](GlobalIndex column) {
      const auto* const found = std::lower_bound(begin, end, numbers.getLocalElement(column));
      return static_cast<int>(found - to.graph.entries.data());
    };
    if (rows_[i] == identity) diagonals_.push_back(place(map->getGlobalElement(row)));
    each_target(
        i, [&](GlobalIndex column) { targets_.push_back(column == absent ? -1 : place(column)); });
  }
}

void SubMatrix::take(const TpetraMatrix& source, const std::vector<double>& row_weights,
                     const std::vector<double>& column_weights) {
  const auto from = source.getLocalMatrixHost();
  const auto to = matrix_->getLocalMatrixHost().values;
  std::fill(to.data(), to.data() + to.extent(0), 0.0);
  for (const int place : diagonals_)
    to(place) = 1;
  auto target = targets_.begin();
  for (const LocalIndex row : rows_) {
    if (row == identity) continue;
    const double weight = row_weights.empty() ? 1 : row_weights[static_cast<std::size_t>(row)];
    for (auto k = from.graph.row_map(row); k < from.graph.row_map(row + 1); ++k, ++target) {
      if (*target < 0) continue;
      const auto column = static_cast<std::size_t>(from.graph.entries(k));
      to(*target) +=
          weight * (column_weights.empty() ? 1 : column_weights[column]) * from.values(k);
    }
  }
}

}  // namespace hawser
