#pragma once
// Anderson acceleration of a fixed-point iteration x -> x + update(x).
#include <Tpetra_Vector.hpp>

#include <deque>
#include <optional>
#include <vector>

#include "hawser/algebra/tpetra_fwd.hpp"

namespace hawser {

class Anderson {
 public:
  explicit Anderson(int depth) : depth_(static_cast<std::size_t>(depth)) {}

  /// Moves x by the update, and by that combination of earlier steps which leaves, were the problem
  /// linear, the least residual. `residual` is the row-scaled one, the measure of least.
  void advance(const TpetraVector& residual, const TpetraVector& update, TpetraVector& x);
  void forget() { history_.clear(), last_.reset(); }

 private:
  struct Pair {
    TpetraVector residual, target;  ///< target: x + update
  };
  std::vector<double> least_squares(const TpetraVector& residual) const;

  std::size_t depth_;
  std::deque<Pair> history_;  ///< differences between successive iterates, the newest first
  std::optional<Pair> last_;
};

}  // namespace hawser
