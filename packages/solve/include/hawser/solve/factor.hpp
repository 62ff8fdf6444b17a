#pragma once
// A (complete or incomplete) factor of one matrix, in phases that are paid for separately.
// It outlives the matrix values it was made from, hence also the time step.
#include <memory>

#include "hawser/algebra/tpetra_fwd.hpp"
#include "hawser/solve/linear_solver.hpp"

namespace hawser {

class Factor {
 public:
  virtual ~Factor() = default;

  /// Once per graph. The matrix stays referenced.
  virtual void symbolic(const Teuchos::RCP<const TpetraMatrix>& matrix) = 0;

  /// From the matrix' present values. SolveError on all ranks when a pivot vanishes.
  virtual void numeric() = 0;

  /// Whether it is the matrix but for round-off.
  virtual bool complete() const { return false; }

  /// x = factor^-1 b, column by column.
  virtual void solve(const TpetraMultiVector& b, TpetraMultiVector& x) const = 0;
};

std::unique_ptr<Factor> make_factor(const Communicator& communicator, const LinearOptions& options);

}  // namespace hawser
