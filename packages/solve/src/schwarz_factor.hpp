#pragma once
// Incomplete LU with fill by level on each rank's rows and an overlap, by Ifpack2.
#include "hawser/solve/factor.hpp"

namespace hawser {

class SchwarzFactor : public Factor {
 public:
  SchwarzFactor(const Communicator& communicator, const LinearOptions& options);
  ~SchwarzFactor() override;
  void symbolic(const Teuchos::RCP<const TpetraMatrix>& matrix) override;
  void numeric() override;
  void solve(const TpetraMultiVector& b, TpetraMultiVector& x) const override;

 private:
  struct Ifpack;
  Communicator communicator_;
  LinearOptions options_;
  std::unique_ptr<Ifpack> ifpack_;
};

}  // namespace hawser
