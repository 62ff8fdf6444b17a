#pragma once
// Complete LU by MUMPS, either of the distributed matrix by all ranks, or repeatably by rank 0
// alone (LinearOptions::repeatable says why).
#include <vector>

#include "hawser/base/types.hpp"
#include "hawser/solve/factor.hpp"

namespace hawser {

class MumpsFactor : public Factor {
 public:
  MumpsFactor(const Communicator& communicator, bool repeatable);
  ~MumpsFactor() override;
  MumpsFactor(const MumpsFactor&) = delete;
  MumpsFactor& operator=(const MumpsFactor&) = delete;
  void symbolic(const Teuchos::RCP<const TpetraMatrix>& matrix) override;
  void numeric() override;
  bool complete() const override { return true; }
  void solve(const TpetraMultiVector& b, TpetraMultiVector& x) const override;

 private:
  struct Mumps;  ///< MUMPS' own structure
  /// What every rank has of a vector, one after the other.
  struct Layout {
    Layout() = default;
    Layout(const Communicator& communicator, int mine);
    std::vector<int> counts, offsets;  ///< per rank; the last offset is the size of the whole
  };
  void number_entries();
  void gather_entries();
  void run(int job) const;  ///< SolveError on all ranks when MUMPS reports one
  bool out_of_space() const;

  Communicator communicator_;
  bool on_root_;  ///< rank 0 factors alone
  Teuchos::RCP<const TpetraMatrix> matrix_;
  std::unique_ptr<Mumps> mumps_;
  std::vector<int> row_numbers_, column_numbers_;  ///< of the entries MUMPS gets here, from 1
  std::vector<double> gathered_;                   ///< values of all entries, on rank 0
  Layout rows_, entries_;
  mutable std::vector<double> whole_;  ///< a whole vector, on rank 0
  mutable int result_[2] = {0, 0};     ///< MUMPS' error code and its detail, on all ranks
};

}  // namespace hawser
