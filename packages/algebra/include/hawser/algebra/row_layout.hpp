#pragma once
// Which rows belong together and how the groups of them hang together, for a preconditioner that
// works group by group. Plain data, filled by those who know meshes, modules and time schemes.
#include <string>
#include <vector>

#include "hawser/base/types.hpp"

namespace hawser {

/// Rows that are solved for together. The same on all ranks.
struct RowGroup {
  std::string name;  ///< of the blocks in it
  /// The unknowns are displacements of nodes, one per dimension, and nothing else: that rigid
  /// motions cost nothing is worth knowing.
  bool displaces = false;
};

/// unknown[row] = RowLayout::factor * unknown[leader] + something known.
struct Follower {
  LocalIndex row;
  LocalIndex leader;
};

struct RowLayout {
  static constexpr int follows = -1;  ///< the group of a row that only follows another

  std::vector<RowGroup> groups;  ///< in the order to solve in; none: nothing is known of the rows
  std::vector<int> group;        ///< per owned row: index in `groups`, or `follows`
  std::vector<LocalIndex> node;  ///< per owned row: this rank's number of its node, ascending
  std::vector<int> kind;         ///< per owned row: which of the `kinds` of unknowns, such as v_x
  int kinds = 0;
  int dimension = 0;
  std::vector<double> positions;    ///< [node][dimension], m, as the matrix was made
  std::vector<Follower> followers;  ///< local rows, ghosts included
  double factor = 0;                ///< of all followers, as the matrix was made
  bool ordered = true;              ///< false: followers do not follow, all is one problem
  std::vector<char> prescribed;     ///< per owned row, as the matrix was made; empty: none
};

}  // namespace hawser
