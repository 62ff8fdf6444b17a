#pragma once
// Newton's method (NOX) on a NonlinearProblem, stopped by the norms of the named blocks.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hawser/algebra/nonlinear_problem.hpp"
#include "hawser/base/types.hpp"
#include "hawser/solve/linear_solver.hpp"

namespace hawser {

struct NonlinearOptions {
  double tolerance = 1e-8;  ///< on every block's ratio; the largest decides
  int max_iterations = 20;

  /// A block also counts as converged when its residual is below this part of |J| |x|: of a flow at
  /// rest or uniform, all contributions are round-off themselves, and their ratio says nothing.
  double round_off = 1e-14;

  /// On every block's error, what the unknowns are still off by relative to their size: the last
  /// update where that is small already, else what the last Jacobian makes of the residual that is
  /// left (Deuflhard's simplified Newton correction). 0: not asked for.
  double update_tolerance = 1e-3;

  /// Halve the step, at most max_cuts times, while it is not admissible: the residual cannot be
  /// evaluated; or a block's has grown by more than allowed_growth, is above small_ratio, and the
  /// correction that it asks for is larger than the step was. A stiff cable's residual grows
  /// although the step is good: it turns segments before it corrects their length. Without line
  /// search the full step is taken or the solve fails.
  bool line_search = true;
  int max_cuts = 8;
  double allowed_growth = 10;
  double small_ratio = 1e-2;
  double divergence = 1e8;  ///< growth of the residual against the first one that ends the solve

  /// Linear tolerance per iteration from the rate of the last (Eisenstat and Walker, their second
  /// choice); else LinearOptions::tolerance throughout.
  bool forcing = false;
  double forcing_max = 1e-2;

  /// Pseudo-transient continuation (Kelley and Keyes 1998): the row-scaled Jacobian plus 1/step on
  /// its diagonal; the step begins with this value and grows as the residual falls. 0: none.
  double pseudo_step = 0;

  /// First iterate on the residual alone, with the Jacobian and factor of an earlier solve,
  /// Anderson-accelerated; Newton takes over from the best iterate when that takes more than
  /// lagged_iterations or the residual grows lagged_growth-fold. Renewing both costs as much as
  /// renewal_cost iterations: they last until a solve takes more iterations than the mean since.
  std::optional<bool> lagged;  ///< not said: the driver's caller knows, else not
  int lagged_iterations = 12;
  int renewal_cost = 8;
  double lagged_growth = 4;
  int anderson_depth = 8;
  double lagged_tolerance = 1e-2;  ///< of the linear solves meanwhile
};

/// How far one block of rows is from balance.
struct BlockNorm {
  std::string block;
  std::string field;
  std::string unit;      ///< of residual and magnitude
  double residual = 0;   ///< 2-norm of the residual
  double magnitude = 0;  ///< 2-norm of the absolute contributions that cancel in it
  double ratio = 0;      ///< residual / magnitude, 0 where the residual is below round-off
  /// What the unknowns are off by, estimated, relative to their size; nothing before the residual
  /// is small enough to ask.
  std::optional<double> error{};
};

/// What decides whether an iterate is the solution: the test that is furthest from being passed.
struct Criterion {
  std::string block, field;
  std::string test;  ///< "residual" (BlockNorm::ratio) or "update" (BlockNorm::error)
  double value = 0;  ///< not above the tolerance: passed
  double tolerance = 1;
};

struct NonlinearReport {
  bool converged = false;
  int iterations = 0;         ///< updates, lagged ones included
  int jacobians = 0;          ///< evaluated
  int linear_iterations = 0;  ///< in all
  int factorizations = 0;
  std::vector<std::string> notes;               ///< of the linear solver, for the user
  std::vector<std::vector<BlockNorm>> history;  ///< per iteration, the start included
  std::vector<double> ratios;                   ///< the worst ratio of each
  std::vector<Criterion> criteria;              ///< what decided on each
};

class NonlinearDriver {
 public:
  NonlinearDriver(NonlinearProblem& problem, LinearOptions linear, NonlinearOptions options);
  ~NonlinearDriver();

  /// From the guess x (on system().rows) to the solution. Collective. SolveError on all ranks when
  /// there is none to be had; x is then the guess again. The linear factor outlives the call.
  NonlinearReport solve(TpetraVector& x);

  /// Names a row in error messages, for example by its node's position; called on the owner only.
  void describe_row(std::function<std::string(GlobalIndex)> describe);

  /// Starts the next solve with a new Jacobian and factor. To be called where a run may be
  /// restarted from (a checkpoint), so that the restarted run repeats this one.
  void forget();

  const LinearSolver& linear_solver() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace hawser
