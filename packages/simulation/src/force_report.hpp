#pragma once
// Forces on regions: the load of one module, or the reaction of the supports.
#include <string>
#include <vector>

#include "hawser/assembly/assembler.hpp"
#include "hawser/simulation/deck_parameters.hpp"

namespace hawser {

/// In N; per metre of depth in a flow in the plane. `across` is 90 degrees to the left of the axis
/// in the plane; in space, where nothing is left, the magnitude of what is normal to the axis.
struct Force {
  double along = 0, across = 0, magnitude = 0;
};

/// The force as seen from an axis (of any length); both have the mesh's dimension.
Force split_force(const std::vector<double>& force, const std::vector<double>& axis);

class ForceReport {
 public:
  ForceReport(const Assembler& assembler, const std::vector<PhysicsModule>& modules,
              const ForceDeck& deck, Diagnostics& diagnostics);

  const std::string& name() const { return deck_.name; }
  /// Load of all modules of that name on the region (minus their residual), or the reaction for
  /// "all". Collective.
  Force measure(const State& state, const std::vector<double>& reactions) const;

 private:
  const Assembler& assembler_;
  ForceDeck deck_;
  std::vector<int> modules_;      // of the name that is asked for; empty: the reaction
  std::vector<LocalIndex> rows_;  // first velocity rows, owned
};

}  // namespace hawser
