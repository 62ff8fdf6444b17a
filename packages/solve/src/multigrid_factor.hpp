#pragma once
// Algebraic multigrid for one group of rows, by MueLu: smoothed aggregation of nodes.
#include "group_rows.hpp"
#include "hawser/base/communicator.hpp"
#include "hawser/solve/factor.hpp"

namespace hawser {

class MultigridFactor : public Factor {
 public:
  /// `group` has places at its nodes (GroupRows::per_node > 0).
  MultigridFactor(const Communicator& communicator, const GroupRows& group);
  ~MultigridFactor() override;

  void symbolic(const Teuchos::RCP<const TpetraMatrix>& matrix) override;
  /// SolveError, on all ranks, when there is no multigrid to be had.
  void numeric() override;
  void solve(const TpetraMultiVector& b, TpetraMultiVector& x) const override;

 private:
  struct Hierarchy;
  Communicator communicator_;
  std::unique_ptr<Hierarchy> hierarchy_;
};

}  // namespace hawser
