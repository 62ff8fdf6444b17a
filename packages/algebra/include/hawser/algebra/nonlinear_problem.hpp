#pragma once
// What Newton's method needs of a discretised problem.
#include <vector>

#include "hawser/algebra/block_system.hpp"

namespace hawser {

class NonlinearProblem {
 public:
  virtual ~NonlinearProblem() = default;
  virtual BlockSystem& system() = 0;

  /// f = residual at x, both on system().rows; `magnitude` (same size) receives, per row, the sum
  /// of the absolute contributions that cancel in f: the scale against which |f| is judged.
  /// Collective. SolveError on all ranks when the state is not admissible (det F <= 0, a value not
  /// finite).
  virtual void residual(const TpetraVector& x, TpetraVector& f, TpetraVector& magnitude) = 0;

  /// Fills system().matrix with the exact derivative of the residual at x. Same errors.
  virtual void jacobian(const TpetraVector& x) = 0;

  /// Whether the equations are still of the kind that the last jacobian() was made for, so that it
  /// may serve once more. The same on all ranks.
  virtual bool jacobian_lasts() const { return true; }
};

}  // namespace hawser
