#pragma once
// An exact solve on some rows and those near them, which mends what a cheap or an old factor of the
// whole leaves there: a stiff structure in a soft fluid changes from matrix to matrix, and no
// smoother sees it.
#include <memory>

#include "mumps_factor.hpp"
#include "sub_matrix.hpp"

namespace hawser {

class Patch {
 public:
  /// `seeds`: per row of the matrix. None on any rank, or most rows near them: there is no patch.
  /// Collective.
  Patch(const Communicator& communicator, const Teuchos::RCP<const TpetraMatrix>& matrix,
        std::vector<char> seeds, bool repeatable);

  bool exists() const { return part_ != nullptr; }
  long long rows() const { return rows_; }  ///< on all ranks

  /// From the matrix' present values.
  void numeric();

  /// y += what takes the residual b - matrix y to zero on the patch.
  void correct(const TpetraVector& b, TpetraVector& y) const;

 private:
  static constexpr int layers = 3;  ///< of cells; two to five do as well

  Teuchos::RCP<const TpetraMatrix> matrix_;
  std::unique_ptr<SubMatrix> part_;
  std::unique_ptr<MumpsFactor> factor_;
  Teuchos::RCP<TpetraVector> residual_, change_;  ///< on the patch
  Teuchos::RCP<TpetraVector> near_;               ///< y with ghosts
  long long rows_ = 0;
};

}  // namespace hawser
