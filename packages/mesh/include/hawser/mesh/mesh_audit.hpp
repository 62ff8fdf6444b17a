#pragma once
// What is wrong with a mesh, or may be, before anything is solved on it.
#include <string>
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

struct MeshFinding {
  enum class Weight {
    note,  ///< a user might mean it
    error  ///< the answer would be wrong
  };
  Weight weight;
  std::string sentence;  ///< what, where (coordinates in m, regions), what to do about it
};

/// Of the whole mesh, as rank 0 prepares it with its edges; a mesh of lines alone has no body and
/// is asked less.
///
/// Errors: nodes at one place that no cell joins, nodes on others' edges, edges of no length, lines
/// that a module or a slit lives on and that share no edge with the body, parts of the body that
/// lie over each other. Notes: boundary edges in no region, cells in no module, parts that share no
/// edge, points of no cell, cells that are nearly flat. `options` says what of this is meant
/// (apart, open_boundary) and by its domains where modules are. MeshError for a region that there
/// is not.
std::vector<MeshFinding> audit(const Mesh& mesh, const MeshOptions& options);

}  // namespace hawser
