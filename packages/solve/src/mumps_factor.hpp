#pragma once
// Complete LU of the distributed matrix by MUMPS.
//
// On several ranks MUMPS schedules dynamically, hence rounds differently from run to run.
#include <vector>

#include "hawser/base/types.hpp"
#include "hawser/solve/factor.hpp"

namespace hawser {

class MumpsFactor : public Factor {
 public:
  explicit MumpsFactor(const Communicator& communicator);
  ~MumpsFactor() override;
  MumpsFactor(const MumpsFactor&) = delete;
  MumpsFactor& operator=(const MumpsFactor&) = delete;
  void symbolic(const Teuchos::RCP<const TpetraMatrix>& matrix) override;
  void numeric() override;
  void solve(const TpetraMultiVector& b, TpetraMultiVector& x) const override;

 private:
  struct Mumps;  ///< MUMPS' own structure
  void number_entries();
  void run(int job) const;  ///< SolveError on all ranks when MUMPS reports one
  int result(int which) const;

  Communicator communicator_;
  Teuchos::RCP<const TpetraMatrix> matrix_;
  std::unique_ptr<Mumps> mumps_;
  std::vector<int> row_numbers_, column_numbers_;  ///< per local entry, from 1, rank after rank
  std::vector<int> counts_, offsets_;              ///< owned rows of every rank
  mutable std::vector<double> whole_;              ///< a whole vector, on rank 0 only
};

}  // namespace hawser
