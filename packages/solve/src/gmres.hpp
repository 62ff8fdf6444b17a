#pragma once
#include "hawser/solve/factor.hpp"

namespace hawser {

struct GmresOutcome {
  bool converged = false;
  int iterations = 0;
};

/// Solves matrix x = b to |b - matrix x| <= tolerance |b|, right-preconditioned, from x = 0.
/// Never throws for numerical reasons: what went wrong shows in the outcome.
GmresOutcome gmres(const Teuchos::RCP<const TpetraMatrix>& matrix, const Factor& factor,
                   const LinearOptions& options, double tolerance, const TpetraVector& b,
                   TpetraVector& x);

}  // namespace hawser
