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
      update_(Teuchos::rcp(new TpetraVector(a_problem.system().rows))) {}

void Newton::forget() {
  linear.forget();
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
  note_update(linear.solve(f, update, tolerance), update);
}

void Newton::approximate_update(const TpetraVector& f, TpetraVector& update) {
  note_update(linear.approximate(f, update, options.lagged_tolerance), update);
}

void Newton::note_update(const LinearReport& solved, TpetraVector& update) {
  update.scale(-1.0);
  update_->update(1.0, update, 0.0);
  ++report.iterations;
  report.linear_iterations += solved.iterations;
  report.factorizations += solved.factored ? 1 : 0;
}

std::vector<BlockNorm> Newton::norms(const TpetraVector& f, const TpetraVector& magnitude) const {
  return block_norms(problem.system(), f, magnitude, scales_, options.round_off);
}

std::vector<double> Newton::last_changes(const TpetraVector& x) const {
  return relative_changes(problem.system(), *update_, x);
}

std::vector<double> Newton::remaining_changes(const TpetraVector& x, const TpetraVector& f) {
  constexpr double tolerance = 1e-2;  // the size is asked for, not the digits
  TpetraVector correction(problem.system().rows);
  report.linear_iterations += linear.solve(f, correction, tolerance).iterations;
  return relative_changes(problem.system(), correction, x);
}

void Newton::estimate_errors(const TpetraVector& x, const TpetraVector& f,
                             std::vector<BlockNorm>& norms) {
  if (options.update_tolerance == 0 || report.iterations == 0 || !balanced(norms)) return;
  const auto note = [&](const std::vector<double>& errors) {
    for (std::size_t i = 0; i < norms.size(); ++i)
      norms[i].error = norms[i].ratio == 0 ? 0 : errors[i];  // below round-off nothing is to be had
  };
  note(last_changes(x));
  if (!balanced(norms)) note(remaining_changes(x, f));
}

Criterion Newton::criterion(const std::vector<BlockNorm>& norms) const {
  const BlockNorm& worst = norms[worst_of(norms)];
  Criterion decides{worst.block, worst.field, "residual", worst.ratio, options.tolerance};
  if (!(worst.ratio <= options.tolerance)) return decides;
  for (const BlockNorm& norm : norms) {
    const double share = norm.error.value_or(0) / options.update_tolerance;
    if (norm.error && !(share <= decides.value / decides.tolerance))
      decides = {norm.block, norm.field, "update", *norm.error, options.update_tolerance};
  }
  return decides;
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
