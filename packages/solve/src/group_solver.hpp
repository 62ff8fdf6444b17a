#pragma once
// One group of rows of a block preconditioner: its matrix, with the followers' columns added to
// their leaders', and how that is solved.
#include <memory>
#include <string>
#include <vector>

#include "group_rows.hpp"
#include "hawser/solve/factor.hpp"
#include "patch.hpp"
#include "sub_matrix.hpp"

namespace hawser {

class GroupSolver {
 public:
  /// `scaled`: the system's matrix, whatever the scale of its rows. Collective.
  GroupSolver(const BlockSystem& system, const TpetraMatrix& scaled, int group,
              const LinearOptions& options);

  /// The matrix' present values, its rows multiplied by `unscale`.
  void take(const TpetraMatrix& scaled, const std::vector<double>& unscale);
  void numeric();  ///< a new factor of them
  void adapt();    ///< the old one, mended where it ages first

  /// x on the group's rows, from b and what x is elsewhere: `all`, with ghosts.
  void solve(const TpetraMatrix& scaled, const std::vector<double>& unscale, const TpetraVector& b,
             const TpetraVector& all, TpetraVector& x) const;

  const std::string& description() const { return description_; }

 private:
  const BlockSystem& system_;
  LinearOptions options_;
  bool as_they_are_;
  std::unique_ptr<SubMatrix> part_;
  std::vector<char> seeds_;  ///< of the patch
  std::unique_ptr<Factor> factor_;
  bool analysed_ = false;
  bool exact_ = true;  ///< the factor is, while it is fresh
  std::unique_ptr<Patch> patch_;
  bool patched_ = false;  ///< the patch is wanted, and of the present values
  Teuchos::RCP<TpetraVector> right_, left_;
  std::string description_;
};

}  // namespace hawser
