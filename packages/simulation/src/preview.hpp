#pragma once
#include <string>

#include "src/system.hpp"

namespace hawser {

/// What a run would need, told without a step of it: unknowns per field, memory, mesh quality and
/// the Courant number of a first step of `length` s, into which `system` is brought. Collective;
/// the text is rank 0's.
std::string preview(System& system, const RunDeck& deck, double length);

/// Nodes, cells per region and quality of a mesh. Collective.
std::string describe_mesh(const Mesh& mesh);

}  // namespace hawser
