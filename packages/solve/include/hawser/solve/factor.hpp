#pragma once
// A (complete or incomplete) factor of one matrix, in phases that are paid for separately.
// It outlives the matrix values it was made from, hence also the time step.
#include <memory>
#include <string>
#include <vector>

#include "hawser/algebra/tpetra_fwd.hpp"
#include "hawser/solve/linear_solver.hpp"

namespace hawser {

class RowScaling;

class Factor {
 public:
  virtual ~Factor() = default;

  /// Once per graph. The matrix stays referenced.
  virtual void symbolic(const Teuchos::RCP<const TpetraMatrix>& matrix) = 0;

  /// From the matrix' present values. SolveError on all ranks when a pivot vanishes.
  virtual void numeric() = 0;

  /// Whether it is the matrix but for round-off.
  virtual bool complete() const { return false; }

  /// The matrix has new values, for which the factor is kept: what costs little is made anew.
  virtual void adapt() {}

  /// GMRES has failed with the factor just made. True: the next numeric() will make a safer one.
  virtual bool fall_back() { return false; }
  /// Undoes all fall_back().
  virtual void start_over() {}

  /// What was decided since the last call that a user may want to know. The same on all ranks.
  virtual std::vector<std::string> take_notes() { return {}; }

  /// x = factor^-1 b, column by column.
  virtual void solve(const TpetraMultiVector& b, TpetraMultiVector& x) const = 0;
};

/// Of the system's matrix, its rows scaled. Both must outlive the factor.
std::unique_ptr<Factor> make_factor(const BlockSystem& system, const RowScaling& scaling,
                                    const LinearOptions& options);

}  // namespace hawser
