#pragma once
// Which rows of the system make one group of a block preconditioner, and in which order.
#include <string>
#include <vector>

#include "hawser/algebra/block_system.hpp"
#include "hawser/solve/linear_solver.hpp"

namespace hawser {

struct GroupRows {
  static constexpr int everything = -2;  ///< all rows as one group, as they are

  std::string name;
  bool as_they_are = false;         ///< everything: followers are unknowns like others
  std::vector<LocalIndex> rows;     ///< of the system; SubMatrix::identity: nothing to solve here
  std::vector<LocalIndex> columns;  ///< owned ones of the system in the same order, likewise
  /// Where multigrid can solve the group: every node has as many places, in one order. 0: it
  /// cannot.
  int per_node = 0;
  int dimension = 0;
  std::vector<double> positions;  ///< then, [node][dimension], m
  bool displaces = false;         ///< RowGroup::displaces
  std::string objection;          ///< why not, where it was wanted
};

/// The rows of the group but for prescribed ones, which are known. Where multigrid is wanted and
/// possible, nodes keep places for those and for unknowns that they lack. There a flow keeps the
/// columns of its prescribed unknowns, too: a constant velocity must have no divergence next to a
/// wall, or the coarse levels are useless. Collective.
GroupRows group_rows(const BlockSystem& system, const TpetraMatrix& matrix, int group,
                     LinearOptions::BlockMethod method);

/// Per local column of the matrix, its number among the group's in `map`; that of a follower is its
/// leader's. Collective.
std::vector<GlobalIndex> group_columns(const BlockSystem& system, const TpetraMatrix& matrix,
                                       const GroupRows& group, const TpetraMap& map);

/// Per row of the group, whether somebody follows an unknown at its node. Collective.
std::vector<char> leaders_nodes(const BlockSystem& system, const GroupRows& group);

}  // namespace hawser
