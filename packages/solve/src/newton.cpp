#include "newton.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

#include "block_norms.hpp"

namespace hawser {

Newton::Newton(NonlinearProblem& a_problem, LinearOptions linear_options,
               NonlinearOptions some_options)
    : problem(a_problem), linear(a_problem.system(), linear_options), options(some_options) {}

void Newton::forget() {
  linear.drop_factor();
  scales_ = {};
}

void Newton::compute_jacobian(const TpetraVector& x) {
  problem.jacobian(x);
  ++report.jacobians;
  linear.matrix_changed(shift);
  scales_ = jacobian_scales(problem.system(), x);
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
  return block_norms(problem.system(), f, magnitude, scales_, options.round_off);
}

Criterion Newton::criterion(const std::vector<BlockNorm>& norms) const {
  const BlockNorm& worst = norms[worst_of(norms)];
  return {worst.block, worst.field, "residual", worst.ratio, options.tolerance};
}

bool Newton::balanced(const std::vector<BlockNorm>& norms) const {
  const Criterion decides = criterion(norms);
  return decides.value <= decides.tolerance;
}

bool Newton::record(const std::vector<BlockNorm>& norms) {
  report.converged = balanced(norms);
  report.ratios.push_back(norms[worst_of(norms)].ratio);
  report.criteria.push_back(criterion(norms));
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
