#include "newton.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

#include "block_norms.hpp"

namespace hawser {

Newton::Newton(NonlinearProblem& a_problem, LinearOptions linear_options,
               NonlinearOptions some_options)
    : problem(a_problem),
      linear(a_problem.system(), linear_options),
      options(some_options),
      round_off_(a_problem.system().blocks.size(), 0.0) {}

void Newton::begin() {
  report = {};
  first_iteration_ = 0;
  jacobian_stamp_ = 0;
  last_linear_ = {};
  last_tolerance_ = 0;
  step_ = 0;
  first_norm_ = previous_norm_ = norm_ = -1;
}

void Newton::forget() {
  linear.drop_factor();
  std::fill(round_off_.begin(), round_off_.end(), 0.0);
}

void Newton::resume() { first_iteration_ = report.iterations; }

void Newton::compute_jacobian(const TpetraVector& x, int stamp) {
  if (has_jacobian(stamp)) return;
  problem.jacobian(x);
  ++report.jacobians;
  linear.matrix_changed();
  round_off_ = product_magnitudes(problem.system(), x);
  for (double& value : round_off_)
    value *= options.round_off;
  jacobian_stamp_ = stamp;
}

void Newton::compute_residual(const TpetraVector& x, TpetraVector& f, TpetraVector& magnitude) {
  problem.residual(x, f, magnitude);
  if (!std::isfinite(f.norm2())) throw failure("the residual is not finite", f, magnitude);
}

void Newton::solve_linear(const TpetraVector& f, TpetraVector& update) {
  last_tolerance_ = linear_tolerance();
  solve_linear(f, update, last_tolerance_);
}

void Newton::solve_linear(const TpetraVector& f, TpetraVector& update, double tolerance) {
  last_linear_ = linear.solve(f, update, tolerance);
  update.scale(-1.0);
}

double Newton::linear_tolerance() const {
  const double tightest = linear.options().tolerance;
  if (!options.forcing) return tightest;
  const double loosest = std::max(tightest, options.forcing_max);
  if (previous_norm_ <= 0) return loosest;
  double wanted = 0.9 * std::pow(norm_ / previous_norm_, 2);
  const double safeguard = 0.9 * std::pow(last_tolerance_, 2);  // no sudden tightening far out
  if (safeguard > 0.1) wanted = std::max(wanted, safeguard);
  return std::clamp(wanted, tightest, loosest);
}

void Newton::accept_step(double step, double from, double to) {
  step_ = step;
  if (first_norm_ < 0) first_norm_ = from;
  previous_norm_ = from;
  norm_ = to;
}

bool Newton::diverges(double norm) const {
  return first_norm_ > 0 && norm > options.divergence * first_norm_;
}

bool Newton::judge(int iteration, const TpetraVector& x, int stamp, const TpetraVector& f,
                   const TpetraVector& magnitude) {
  auto norms = block_norms(problem.system(), f, magnitude, round_off_);
  auto worst = static_cast<std::size_t>(worst_of(norms));
  if (stamp > 0 && iteration == 0 && norms[worst].ratio > options.tolerance) {
    compute_jacobian(x, stamp);  // needed next anyway; it tells what is round-off at the start
    norms = block_norms(problem.system(), f, magnitude, round_off_);
    worst = static_cast<std::size_t>(worst_of(norms));
  }
  report.converged = norms[worst].ratio <= options.tolerance;
  report.iterations = first_iteration_ + iteration;
  report.linear_iterations += last_linear_.iterations;
  report.factorizations += last_linear_.factored ? 1 : 0;
  report.history.push_back(norms);
  report.ratios.push_back(norms[worst].ratio);
  if (on_iteration) {
    on_iteration({report.iterations, step_, last_linear_.iterations, last_linear_.reached,
                  last_linear_.factored, norms[worst].ratio, static_cast<int>(worst),
                  std::move(norms)});
  }
  last_linear_ = {};
  return report.converged;
}

SolveError Newton::failure(const std::string& what, const TpetraVector& f,
                           const TpetraVector& magnitude) const {
  const auto& system = problem.system();
  const auto norms = block_norms(system, f, magnitude, round_off_);
  const auto worst = static_cast<std::size_t>(worst_of(norms));
  return SolveError("Newton: " + what + "; " +
                    describe_block(system, norms[worst], system.blocks[worst], f, describe_row));
}

}  // namespace hawser
