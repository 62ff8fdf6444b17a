#pragma once
// Who supplies which property to whom.
#include <vector>

#include "hawser/deck/diagnostics.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/physics/kernel.hpp"

namespace hawser {

/// Gives every kernel the properties that modules supply on its cells. Before fields are gathered:
/// what a source reads becomes a field of the kernel. Faults, on all ranks alike: a property that
/// no module uses, one that a kernel uses and nobody supplies, two suppliers that do not both add,
/// names in a formula that are no field.
/// PluginError: units or components of one name that differ.
void connect_properties(const Mesh& mesh, std::vector<PhysicsModule>& modules,
                        Diagnostics& diagnostics);

/// [cell of the region]: 1 where its vertices are those of a cell of the body in `on`; a facet
/// counts with the cell behind it.
std::vector<char> cells_within(const Mesh& mesh, const Region& region, const Domain& on);

}  // namespace hawser
