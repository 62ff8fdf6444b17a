#pragma once
// One Tpetra matrix and its vectors, with named blocks of rows.
#include <string>
#include <vector>

#include "hawser/algebra/row_layout.hpp"
#include "hawser/algebra/tpetra_fwd.hpp"
#include "hawser/base/communicator.hpp"
#include "hawser/base/types.hpp"

namespace hawser {

/// The rows of one field in one named block, e.g. block "fluid", field "velocity", residual in N.
struct Block {
  std::string name;              ///< fluid, structure, mesh, or a plug-in's own
  std::string field;             ///< velocity, pressure, displacement, ...
  std::string unit;              ///< unit of the residual's entries
  std::vector<LocalIndex> rows;  ///< owned local rows, ascending
  bool has_level = false;  ///< of the unknowns only differences count, over all blocks of the field
  /// Per row: by how much its unknown must be off to be wholly wrong, in the unknown's unit. Empty:
  /// nobody can say; then the row is judged by what cancels in it.
  std::vector<double> sizes{};
};

struct BlockSystem {
  Communicator communicator;
  Teuchos::RCP<const TpetraMap> rows;     ///< owned unknowns; also domain and range map
  Teuchos::RCP<const TpetraMap> columns;  ///< owned, then ghost unknowns
  Teuchos::RCP<TpetraMatrix> matrix;  ///< fill-complete, fixed graph; values rewritten per Jacobian
  std::vector<Block> blocks;          ///< disjoint, together all owned rows
  RowLayout layout{};

  double entries() const;  ///< of the matrix, on all ranks
};

}  // namespace hawser
