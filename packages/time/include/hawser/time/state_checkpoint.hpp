#pragma once
// The time history and what cells remember as arrays by rank-independent numbers, and back on any
// number of ranks.
#include <string>
#include <vector>

#include "hawser/assembly/cell_memory.hpp"
#include "hawser/fields/dof_map.hpp"
#include "hawser/output/checkpoint.hpp"
#include "hawser/time/time_integrator.hpp"

namespace hawser {

/// The state as write_checkpoint() wants it, with what else the header holds. Collective.
Checkpoint checkpoint_of(const DofMap& dofs, const TimeHistory& history,
                         const std::vector<CellMemory*>& memories, CheckpointHeader header);
/// OutputError when the checkpoint belongs to another mesh or other modules.
TimeHistory load_history(const DofMap& dofs, const CheckpointReader& reader);
/// The same for what cells remember.
void load_memories(const Mesh& mesh, const CheckpointReader& reader,
                   const std::vector<CellMemory*>& memories);

/// What another run's checkpoint has of this one's fields.
struct TakenFields {
  std::vector<std::string> taken;
  std::vector<std::string> absent;  ///< there; `state` keeps what it has of them
  std::vector<std::string> unused;  ///< here
};
/// Values and rates by the names of fields, the deck, its modules and its ranks being others.
/// OutputError when the checkpoint belongs to another mesh, or has a field in another basis.
/// Collective.
TakenFields take_fields(const DofMap& dofs, const CheckpointReader& reader, State& state);

}  // namespace hawser
