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

void Newton::forget() {
  linear.drop_factor();
  std::fill(round_off_.begin(), round_off_.end(), 0.0);
}

void Newton::compute_jacobian(const TpetraVector& x) {
  problem.jacobian(x);
  ++report.jacobians;
  linear.matrix_changed(shift);
  round_off_ = product_magnitudes(problem.system(), x);
  for (double& value : round_off_)
    value *= options.round_off;
}

void Newton::compute_residual(const TpetraVector& x, TpetraVector& f, TpetraVector& magnitude) {
  problem.residual(x, f, magnitude);
  if (!std::isfinite(f.norm2())) throw failure("the residual is not finite", f, magnitude);
}

void Newton::compute_update(const TpetraVector& f, TpetraVector& update, double tolerance) {
  const LinearReport solved = linear.solve(f, update, tolerance);
  update.scale(-1.0);
  ++report.iterations;
  report.linear_iterations += solved.iterations;
  report.factorizations += solved.factored ? 1 : 0;
}

std::vector<BlockNorm> Newton::norms(const TpetraVector& f, const TpetraVector& magnitude) const {
  return block_norms(problem.system(), f, magnitude, round_off_);
}

bool Newton::balanced(const std::vector<BlockNorm>& norms) const {
  return norms[worst_of(norms)].ratio <= options.tolerance;
}

bool Newton::record(const std::vector<BlockNorm>& norms) {
  report.converged = balanced(norms);
  report.ratios.push_back(norms[worst_of(norms)].ratio);
  report.history.push_back(norms);
  return report.converged;
}

SolveError Newton::failure(const std::string& what, const TpetraVector& f,
                           const TpetraVector& magnitude) const {
  const auto& system = problem.system();
  const auto blocks = norms(f, magnitude);
  const std::size_t worst = worst_of(blocks);
  return SolveError("Newton: " + what + "; " +
                    describe_block(system, blocks[worst], system.blocks[worst], f, describe_row));
}

}  // namespace hawser
