#pragma once
// What NOX's parts (group, line search, status tests) share during one solve.
#include <functional>
#include <string>
#include <vector>

#include "block_norms.hpp"
#include "hawser/base/error.hpp"
#include "hawser/solve/nonlinear_driver.hpp"

namespace hawser {

class Newton {
 public:
  Newton(NonlinearProblem& problem, LinearOptions linear, NonlinearOptions options);

  void forget();  ///< all that earlier solves left behind

  void compute_jacobian(const TpetraVector& x);

  /// SolveError when not admissible, or not finite.
  void compute_residual(const TpetraVector& x, TpetraVector& f, TpetraVector& magnitude);

  /// update = -J^-1 f with the last Jacobian.
  void compute_update(const TpetraVector& f, TpetraVector& update, double tolerance);
  /// The same with what is at hand of an earlier Jacobian (LinearSolver::approximate).
  void approximate_update(const TpetraVector& f, TpetraVector& update);
  /// The last update, and what the last Jacobian says that x is off by where the residual is f; per
  /// block, relative to the unknowns there.
  std::vector<double> last_changes(const TpetraVector& x) const;
  std::vector<double> remaining_changes(const TpetraVector& x, const TpetraVector& f);
  /// Completes the norms of an iterate that is in balance by the errors of its unknowns.
  void estimate_errors(const TpetraVector& x, const TpetraVector& f, std::vector<BlockNorm>& norms);

  std::vector<BlockNorm> norms(const TpetraVector& f, const TpetraVector& magnitude) const;
  Criterion criterion(const std::vector<BlockNorm>& norms) const;
  bool balanced(const std::vector<BlockNorm>& norms) const;
  /// Whether an iterate with these norms is the solution; the report has them from now on.
  bool record(const std::vector<BlockNorm>& norms);

  /// `what`, then what is wrong with the worst block of the iterate.
  SolveError failure(const std::string& what, const TpetraVector& f,
                     const TpetraVector& magnitude) const;

  NonlinearProblem& problem;
  LinearSolver linear;
  NonlinearOptions options;
  NonlinearReport report;
  std::function<std::string(GlobalIndex)> describe_row;
  double shift = 0;  ///< 1 / the present step of pseudo-transient continuation; 0: there is none

 private:
  void note_update(const LinearReport& solved, TpetraVector& update);

  JacobianScales scales_;              ///< of the last Jacobian
  Teuchos::RCP<TpetraVector> update_;  ///< the last one
};

}  // namespace hawser
