#pragma once
// Who supplies which property to whom.
#include <vector>

#include "hawser/deck/diagnostics.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/physics/kernel.hpp"

namespace hawser {

/// Finds the fields that formulas name. Needs no mesh. Faults: names that are no field, a property
/// that no module uses, a unit that does not fit.
/// PluginError: units or components of one name that differ.
void resolve_properties(std::vector<PhysicsModule>& modules, Diagnostics& diagnostics);

/// Gives every kernel the properties that modules supply on its cells, once they are resolved.
/// Before fields are gathered: what a source reads becomes a field of the kernel. Faults, on all
/// ranks alike: a property that a kernel uses and nobody supplies, two suppliers that do not both
/// add.
void connect_properties(const Mesh& mesh, std::vector<PhysicsModule>& modules,
                        Diagnostics& diagnostics);

/// [cell of the region]: 1 where its vertices are those of a cell of the body in `on`; a facet
/// counts with the cell behind it.
std::vector<char> cells_within(const Mesh& mesh, const Region& region, const Domain& on);

}  // namespace hawser
