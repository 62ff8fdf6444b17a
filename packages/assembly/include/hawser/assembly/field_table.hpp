#pragma once
// The fields of a run, gathered from what the modules declare.
#include <vector>

#include "hawser/fields/dof_map.hpp"
#include "hawser/physics/kernel.hpp"

namespace hawser {

struct FieldTable {
  std::vector<FieldDescription> fields;
  std::vector<RateRule> rate_rules;  ///< per field
};

/// A field lives on the union of the regions where some module adds to, governs or drives it.
/// Structures' displacements come first and scalars last, which suits incomplete factorisations.
/// PluginError when two modules describe a field of one name differently.
FieldTable gather_fields(const std::vector<PhysicsModule>& modules);

}  // namespace hawser
