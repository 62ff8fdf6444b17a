#include "hawser/solve/linear_solver.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gmres.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/stopwatch.hpp"
#include "row_scaling.hpp"
#include "with_ghosts.hpp"

namespace hawser {

struct LinearSolver::Implementation {
  Implementation(BlockSystem& a_system, LinearOptions some_options)
      : system(a_system),
        options(some_options),
        factor(make_factor(a_system, scaling, some_options)),
        scaled(Teuchos::rcp(new TpetraMatrix(a_system.matrix->getCrsGraph()))),
        b(a_system.rows),
        remainder(a_system.rows) {
    scaled->fillComplete(system.rows, system.rows);
  }

  void scale_matrix() {
    if (!matrix_is_new) return;
    if (refresh_due) scaling.compute(*system.matrix, system.communicator);
    scaling.apply(*system.matrix, *scaled);
    if (shift != 0) add_to_diagonal();
    if (!refresh_due) factor->adapt();
    matrix_is_new = false;
  }

  void add_to_diagonal() {
    const auto local = scaled->getLocalMatrixHost();  // columns: the rows, then the ghosts
    for (LocalIndex row = 0; row < local.numRows(); ++row)
      for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k)
        if (local.graph.entries(k) == row) local.values(k) += shift;
  }

  void refresh() {
    const auto lap = factor_watch.lap();
    matrix_is_new = true;  // the scaling is made anew with the factor, and kept as long
    refresh_due = true;
    scale_matrix();
    if (!analysed) factor->symbolic(scaled);
    analysed = true;
    factor->numeric();
    prescribed = system.layout.prescribed;
    ++factorizations;
    refresh_due = false;
    fresh_effort = -1;
  }

  double relative_residual(const TpetraVector& x) {
    scaled->apply(x, remainder);
    remainder.update(1.0, b, -1.0);
    return remainder.norm2() / b.norm2();
  }

  /// Largest over the rows of |b - A x| / (|A| |x| + |b|): how far from A the matrix is that x
  /// solves exactly (Oettli and Prager, Numer. Math. 6 (1964) 405-409). After relative_residual(x).
  double backward_error(const TpetraVector& x) {
    const auto local = scaled->getLocalMatrixHost();
    TpetraVector columns(scaled->getColMap());
    with_ghosts(*scaled, x, columns);
    const auto values = columns.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto rhs = b.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto rest = remainder.getLocalViewHost(Tpetra::Access::ReadOnly);
    double worst = 0;
    for (LocalIndex row = 0; row < local.numRows(); ++row) {
      double size = std::abs(rhs(row, 0));
      for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k)
        size += std::abs(local.values(k) * values(local.graph.entries(k), 0));
      if (rest(row, 0) != 0) worst = std::max(worst, std::abs(rest(row, 0)) / size);
    }
    return system.communicator.max(worst);
  }

  /// Decides from iteration counts alone whether the factor still pays. Forcing terms change the
  /// tolerance from solve to solve, so what is compared are iterations per decade: the fewest that
  /// the factor has taken, because a loose solve takes more of them.
  void judge_factor(int iterations, double tolerance) {
    const double decades = std::max(-std::log10(tolerance), 1e-3);
    const double effort = iterations / decades;
    fresh_effort = fresh_effort < 0 ? effort : std::min(fresh_effort, effort);
    refresh_due =
        iterations > options.refresh_ratio * fresh_effort * decades + options.refresh_slack;
  }

  BlockSystem& system;
  LinearOptions options;
  RowScaling scaling;
  std::unique_ptr<Factor> factor;
  Teuchos::RCP<TpetraMatrix> scaled;  ///< the matrix, rows scaled; a copy
  TpetraVector b;                     ///< the right-hand side, scaled
  TpetraVector remainder;
  std::vector<char> prescribed;  ///< rows, when the factor was made
  double shift = 0;
  bool matrix_is_new = true;
  bool refresh_due = true;
  bool analysed = false;
  double fresh_effort = -1;  ///< the fewest iterations per decade with the factor; -1: none yet
  int factorizations = 0;
  Stopwatch factor_watch, solve_watch;
};

namespace {

constexpr double has_digits = 1e-4;  // relative residual; that of a singular matrix has none
constexpr double rounding = 1e-14;   // backward error of a solution as good as doubles allow

SolveError failure(const GmresOutcome& outcome, double reached, double tolerance) {
  char text[160];
  std::snprintf(
      text, sizeof text,
      "linear solver: GMRES reached a relative residual of %.2e after %d iterations with a "
      "fresh factor, wanted %.2e",
      reached, outcome.iterations, tolerance);
  return SolveError(text);
}

}  // namespace

LinearSolver::LinearSolver(BlockSystem& system, LinearOptions options)
    : implementation_(std::make_unique<Implementation>(system, options)) {}
LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

void LinearSolver::matrix_changed(double shift) {
  implementation_->matrix_is_new = true;
  implementation_->shift = shift;
  const BlockSystem& system = implementation_->system;
  if (!implementation_->options.keep_factor ||
      system.communicator.any(system.layout.prescribed != implementation_->prescribed))
    drop_factor();
}

void LinearSolver::drop_factor() { implementation_->refresh_due = true; }

void LinearSolver::forget() {
  implementation_->factor->start_over();
  drop_factor();
}

std::vector<std::string> LinearSolver::take_notes() {
  return implementation_->factor->take_notes();
}

const LinearOptions& LinearSolver::options() const { return implementation_->options; }

int LinearSolver::factorizations() const { return implementation_->factorizations; }

double LinearSolver::factor_seconds() const { return implementation_->factor_watch.seconds(); }

double LinearSolver::solve_seconds() const { return implementation_->solve_watch.seconds(); }

void LinearSolver::scale(const TpetraVector& residual, TpetraVector& scaled) const {
  implementation_->scaling.apply(residual, scaled);
}

double LinearSolver::scaled_norm(const TpetraVector& residual) {
  auto& self = *implementation_;
  scale(residual, self.remainder);
  return self.remainder.norm2();
}

bool LinearSolver::prepare() {
  const bool due = implementation_->refresh_due;
  if (due) implementation_->refresh();
  return due;
}

LinearReport LinearSolver::approximate(const TpetraVector& rhs, TpetraVector& x, double tolerance) {
  auto& self = *implementation_;
  if (!self.factor->complete()) return solve(rhs, x, tolerance);
  LinearReport report;
  report.factored = prepare();
  const auto lap = self.solve_watch.lap();
  self.scaling.apply(rhs, self.b);
  self.factor->solve(self.b, x);
  report.iterations = 1;
  return report;
}

LinearReport LinearSolver::solve(const TpetraVector& rhs, TpetraVector& x) {
  return solve(rhs, x, options().tolerance);
}

LinearReport LinearSolver::solve(const TpetraVector& rhs, TpetraVector& x, double tolerance) {
  auto& self = *implementation_;
  LinearReport report;
  const auto refresh = [&] {
    self.refresh();
    report.factored = true;
  };
  if (self.refresh_due) refresh();
  self.scale_matrix();
  self.scaling.apply(rhs, self.b);
  const double size = self.b.norm2();
  if (!std::isfinite(size))
    throw SolveError("linear solver: the right-hand side holds a value that is not finite");
  if (size == 0) {
    x.putScalar(0.0);
    return report;
  }

  const auto attempt = [&] {
    const auto lap = self.solve_watch.lap();
    const auto outcome = gmres(self.scaled, *self.factor, self.options, tolerance, self.b, x);
    report.iterations += outcome.iterations;
    report.reached = self.relative_residual(x);
    // Belos' own count of the residual drifts from the true one; a factor of two is harmless. A
    // solution that is exact for a matrix so near cannot be bettered in doubles, however small the
    // right-hand side is beside the terms that cancel.
    const bool good = (outcome.converged && report.reached <= 2 * tolerance) ||
                      (self.factor->complete() && report.reached <= has_digits &&
                       self.backward_error(x) <= rounding);
    return std::pair(outcome, good);
  };
  auto [outcome, good] = attempt();
  if (!good && !report.factored) {
    refresh();
    self.scaling.apply(rhs, self.b);
    std::tie(outcome, good) = attempt();
  }
  while (!good && self.factor->fall_back()) {
    refresh();
    self.scaling.apply(rhs, self.b);
    std::tie(outcome, good) = attempt();
  }
  if (!good) {
    self.refresh_due = true;
    throw failure(outcome, report.reached, tolerance);
  }
  self.judge_factor(outcome.iterations, tolerance);
  return report;
}

}  // namespace hawser
