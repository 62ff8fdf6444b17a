#pragma once
// Solves the block system's linear equations: GMRES, preconditioned by a factor that may be kept
// for later matrices. Rows carry different physical units (N, m^2/s, m); scaling them is done in
// here.
#include <memory>
#include <string>
#include <vector>

#include "hawser/algebra/block_system.hpp"

namespace hawser {

struct LinearOptions {
  enum class Method {
    gmres,  ///< preconditioned by an incomplete factor, overlapping Schwarz between the ranks
    mumps,  ///< preconditioned by MUMPS' complete factor: one iteration while the factor is fresh
    blocks  ///< preconditioned group by group, as the system's layout says
  };
  enum class BlockMethod {
    automatic,  ///< multigrid for large groups, direct for small ones
    direct,     ///< MUMPS
    multigrid   ///< smoothed aggregation
  };
  Method method = Method::gmres;
  BlockMethod block_method = BlockMethod::automatic;  ///< of each group
  double tolerance = 1e-6;   ///< of the residual's 2-norm to the right-hand side's, both row-scaled
  int restart = 100;         ///< GMRES vectors kept before a restart
  int max_iterations = 300;  ///< GMRES iterations, over all restarts
  int fill_level = 1;        ///< of the incomplete factor
  int overlap = 1;           ///< Schwarz overlap between ranks, in layers of the matrix graph

  /// MUMPS schedules dynamically on several ranks and so rounds differently from run to run. With
  /// `repeatable` rank 0 factors alone: some 30 % slower on two ranks, and bit for bit the same.
  bool repeatable = true;

  /// Keep the factor for later matrices until a solve with it takes more than
  /// refresh_ratio * n + refresh_slack iterations, n being those of its first solve, or fails.
  /// Only iterations count, never measured time: the same run twice is the same to the last bit.
  /// With another set of prescribed rows a factor is not worth trying.
  bool keep_factor = false;
  double refresh_ratio = 1.5;
  int refresh_slack = 5;
};

struct LinearReport {
  int iterations = 0;
  double reached = 0;     ///< true residual over right-hand side, both row-scaled
  bool factored = false;  ///< a new factor was made for this solve
};

class LinearSolver {
 public:
  /// The system must outlive the solver, and its matrix keep its graph.
  LinearSolver(BlockSystem& system, LinearOptions options);
  ~LinearSolver();
  LinearSolver(LinearSolver&&) noexcept;
  LinearSolver& operator=(LinearSolver&&) noexcept;

  /// To be called after the matrix got new values. What is solved from now on is the row-scaled
  /// matrix plus `shift` on its diagonal.
  void matrix_changed(double shift = 0);

  /// The next solve makes a new factor, whatever the refresh rule says.
  void drop_factor();
  /// The same, and what earlier solves have taught is forgotten.
  void forget();

  /// x = matrix^-1 rhs, from a zero initial guess. Collective. SolveError on all ranks when the
  /// matrix is singular, a value is not finite, or GMRES fails with a fresh factor too.
  LinearReport solve(const TpetraVector& rhs, TpetraVector& x, double tolerance);
  LinearReport solve(const TpetraVector& rhs, TpetraVector& x);  ///< to options().tolerance

  /// Makes the factor now, if the next solve would; true when it did. Norms of residuals are by the
  /// row scaling that belongs to it.
  bool prepare();

  /// About matrix^-1 rhs, for an iteration that corrects itself: what a complete factor, be it of
  /// an earlier matrix, makes of rhs; where the factor is none, solve() to `tolerance`.
  LinearReport approximate(const TpetraVector& rhs, TpetraVector& x, double tolerance);

  /// The residual, rows scaled, and its 2-norm, which is what solve() reduces. After a first solve.
  void scale(const TpetraVector& residual, TpetraVector& scaled) const;
  double scaled_norm(const TpetraVector& residual);

  /// What was decided since the last call that a user may want to know. The same on all ranks.
  std::vector<std::string> take_notes();

  const LinearOptions& options() const;
  int factorizations() const;  ///< made since construction

  double factor_seconds() const;  ///< this rank's wall time in making factors
  double solve_seconds() const;   ///< and in GMRES, the factors' application included

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace hawser
