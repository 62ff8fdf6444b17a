#pragma once
// Norms of the difference between a field and its exact solution.
#include <string>
#include <vector>

#include "hawser/fields/dof_map.hpp"
#include "hawser/fields/state.hpp"
#include "hawser/simulation/verification_deck.hpp"

namespace hawser {

struct ErrorNorms {
  double l2 = 0;   ///< root of the integral over the moved region
  double max = 0;  ///< largest component at any quadrature point
};

class ErrorReport {
 public:
  /// Faults (unknown field or region, number of components) go to `diagnostics`.
  ErrorReport(const DofMap& dofs, const ErrorDeck& deck, Diagnostics& diagnostics);

  const std::string& name() const { return deck_.name; }
  int field() const { return field_; }  ///< index in the DofMap

  /// `state` stands at the instant at which the field lives; time and geometry are its. Collective;
  /// SolveError where the exact solution has no value.
  ErrorNorms measure(const State& state) const;

 private:
  struct Sample {
    double weight;  ///< m^2 or m
    double error[3];
  };
  std::vector<Sample> sample(const State& state) const;

  const DofMap& dofs_;
  ErrorDeck deck_;
  const Region* region_ = nullptr;
  int field_ = -1;
  std::size_t components_ = 0;
};

}  // namespace hawser
