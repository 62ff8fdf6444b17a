#pragma once
// What NOX's parts (group, line search, status test) share during one solve.
#include <functional>
#include <string>
#include <vector>

#include "hawser/base/error.hpp"
#include "hawser/solve/nonlinear_driver.hpp"

namespace hawser {

class Newton {
 public:
  Newton(NonlinearProblem& problem, LinearOptions linear, NonlinearOptions options);

  void begin();   ///< a new solve
  void forget();  ///< all that earlier solves left behind
  void resume();  ///< the same solve by another method, which counts its iterations from 0 again

  /// An iterate's identity: two vectors with one stamp are the same, so their Jacobian is.
  int new_stamp() { return next_stamp_++; }
  bool has_jacobian(int stamp) const { return stamp == jacobian_stamp_; }
  void compute_jacobian(const TpetraVector& x, int stamp);

  /// SolveError when not admissible, or not finite.
  void compute_residual(const TpetraVector& x, TpetraVector& f, TpetraVector& magnitude);

  /// update = -J^-1 f with the last Jacobian, to the tolerance that Newton wants or the one given.
  void solve_linear(const TpetraVector& f, TpetraVector& update);
  void solve_linear(const TpetraVector& f, TpetraVector& update, double tolerance);
  const LinearReport& last_linear() const { return last_linear_; }

  /// The line search took this part of the update, from one row-scaled residual norm to another.
  void accept_step(double step, double from, double to);
  bool diverges(double norm) const;

  /// Judges an iterate, records and reports it. `iteration` counts from the last begin() or
  /// resume(); with a stamp of 0 no Jacobian is made to judge by.
  bool judge(int iteration, const TpetraVector& x, int stamp, const TpetraVector& f,
             const TpetraVector& magnitude);

  /// `what`, then what is wrong with the worst block of the iterate.
  SolveError failure(const std::string& what, const TpetraVector& f,
                     const TpetraVector& magnitude) const;

  NonlinearProblem& problem;
  LinearSolver linear;
  NonlinearOptions options;
  NonlinearReport report;
  std::function<void(const IterationReport&)> on_iteration;
  std::function<std::string(GlobalIndex)> describe_row;

 private:
  double linear_tolerance() const;

  int first_iteration_ = 0;
  int next_stamp_ = 1;
  int jacobian_stamp_ = 0;
  std::vector<double> round_off_;  ///< per block, the residual that counts as none
  LinearReport last_linear_;
  double last_tolerance_ = 0;
  double step_ = 0;
  double first_norm_ = -1, previous_norm_ = -1, norm_ = -1;  ///< row-scaled; -1: not known yet
};

}  // namespace hawser
