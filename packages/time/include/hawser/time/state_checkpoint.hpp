#pragma once
// The time history as arrays by rank-independent numbers, and back on any number of ranks.
#include <string>

#include "hawser/fields/dof_map.hpp"
#include "hawser/output/checkpoint.hpp"
#include "hawser/time/time_integrator.hpp"

namespace hawser {

/// Collective; OutputError on all ranks.
void save_history(const DofMap& dofs, const TimeHistory& history, CheckpointHeader header,
                  const std::string& path);
/// OutputError when the checkpoint belongs to another mesh or other modules.
TimeHistory load_history(const DofMap& dofs, const CheckpointReader& reader);

}  // namespace hawser
