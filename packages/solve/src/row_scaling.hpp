#pragma once
// Brings rows of different physical units to entries of order one.
//
// Only rows are scaled. GMRES preconditioned from the right by an incomplete factor makes the same
// iterates whatever the scale of the columns, and MUMPS scales columns itself.
#include <vector>

#include "hawser/algebra/tpetra_fwd.hpp"
#include "hawser/base/communicator.hpp"
#include "hawser/base/types.hpp"

namespace hawser {

class RowScaling {
 public:
  /// Takes each row's largest entry to [1, 2), by a power of two, so that scaling rounds nothing.
  /// SolveError on all ranks when a row is zero or holds a value that is not finite.
  void compute(const TpetraMatrix& matrix, const Communicator& communicator);

  const std::vector<double>& factors() const { return factors_; }  ///< per owned row

  void apply(const TpetraMatrix& from, TpetraMatrix& to) const;  ///< both with one graph
  void apply(const TpetraVector& from, TpetraVector& to) const;

 private:
  std::vector<double> factors_;  ///< per owned row
};

}  // namespace hawser
