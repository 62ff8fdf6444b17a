#pragma once
// Which rows of a global table this rank holds.
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/base/types.hpp"

namespace hawser {

/// Ids, any distinct numbers, in the order of a table that has one row per id, sorted by id.
class Rows {
 public:
  /// Every id of 0 .. count-1, or of any other set of `count` ids, on exactly one rank. Collective.
  Rows(const Communicator& communicator, GlobalIndex count, const std::vector<GlobalIndex>& ids);

  GlobalIndex count() const { return count_; }
  const std::vector<GlobalIndex>& positions() const { return positions_; }  ///< of the own ids
  GlobalIndex position(GlobalIndex id) const;                               ///< of any rank's id

 private:
  GlobalIndex count_;
  std::vector<GlobalIndex> all_ids_;  ///< sorted; empty when the ids are 0 .. count-1
  std::vector<GlobalIndex> positions_;
};

}  // namespace hawser
