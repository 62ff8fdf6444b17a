#pragma once
#include <vector>

#include "body.hpp"

namespace hawser {

/// Adds to the whole mesh what is made of its named regions for `domains`, as far as there is any.
/// MeshError for patches where a line branches; a note where lines with patches meet.
void derive(Mesh& mesh, const EdgeSides& sides, const std::vector<Domain>& domains);

}  // namespace hawser
