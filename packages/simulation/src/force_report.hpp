#pragma once
// Forces on regions: the load of one module, or the reaction of the supports.
#include <string>
#include <vector>

#include "hawser/assembly/assembler.hpp"
#include "hawser/simulation/deck_parameters.hpp"

namespace hawser {

/// N per metre of depth in two dimensions.
struct Force {
  double along = 0, across = 0, magnitude = 0;
};

class ForceReport {
 public:
  ForceReport(const Assembler& assembler, const std::vector<PhysicsModule>& modules,
              const ForceDeck& deck, Diagnostics& diagnostics);

  const std::string& name() const { return deck_.name; }
  /// Load of the module on the region (minus its residual), or the reaction for "all". Collective.
  Force measure(const State& state, const std::vector<double>& reactions) const;

 private:
  const Assembler& assembler_;
  ForceDeck deck_;
  int module_ = Assembler::all_modules;
  std::vector<LocalIndex> rows_;  // first velocity rows, owned
};

}  // namespace hawser
