#pragma once
// Some rows and columns of a matrix as a matrix of their own, its values to be taken again and
// again. Columns may be added to others with a weight: u_i = w u_j + known takes u_i out.
#include <vector>

#include "hawser/algebra/tpetra_fwd.hpp"
#include "hawser/base/types.hpp"

namespace hawser {

/// Values that this rank has for `rows`, one each, for all columns of the matrix, ghosts included.
/// Collective.
std::vector<GlobalIndex> spread(const TpetraMatrix& matrix, const std::vector<GlobalIndex>& rows);

class SubMatrix {
 public:
  static constexpr LocalIndex identity = -1;
  static constexpr GlobalIndex absent = -1;

  /// `rows`: of the source, which become the rows of `map`; identity: a one on the diagonal.
  /// `columns`: per local column of the source, its number in `map`, or absent. Collective.
  SubMatrix(const TpetraMatrix& source, std::vector<LocalIndex> rows,
            const Teuchos::RCP<const TpetraMap>& map, const std::vector<GlobalIndex>& columns);

  /// The source has the graph that it had. Per row and local column of the source a factor; of
  /// those that are not given it is one.
  void take(const TpetraMatrix& source, const std::vector<double>& row_weights = {},
            const std::vector<double>& column_weights = {});

  const Teuchos::RCP<TpetraMatrix>& matrix() const { return matrix_; }
  const std::vector<LocalIndex>& rows() const { return rows_; }

 private:
  std::vector<LocalIndex> rows_;
  Teuchos::RCP<TpetraMatrix> matrix_;
  std::vector<int> targets_;    ///< per entry of the rows in the source: its place here, or -1
  std::vector<int> diagonals_;  ///< places of the ones
};

/// Consecutive numbers on each rank, `mine` on this one. Collective.
Teuchos::RCP<const TpetraMap> consecutive(const TpetraMap& like, std::size_t mine);

}  // namespace hawser
