#pragma once
// What a deck calls by name: regions of the mesh and fields of the modules. A name that is not
// there, or not of the wanted kind, is an error that tells what there is.
#include <string>
#include <vector>

#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/value.hpp"
#include "hawser/fields/dof_map.hpp"

namespace hawser {

/// Null, and an error, when there is none. All of this is the same on all ranks.
const Region* find_region(const Mesh& mesh, const std::string& name, const Location& where,
                          Diagnostics& diagnostics);
inline const Region* find_region(const Mesh& mesh, const Located<std::string>& name,
                                 Diagnostics& diagnostics) {
  return find_region(mesh, name.value, name.location, diagnostics);
}

/// Null, and an error saying that `user` needs it, unless the region is one point. Collective.
const Region* find_point(const Mesh& mesh, const Located<std::string>& name,
                         const std::string& user, Diagnostics& diagnostics);

/// Null, and an error, unless its cells have one of the shapes.
const Region* find_region_of(const std::vector<CellShape>& shapes, const Mesh& mesh,
                             const Located<std::string>& name, const std::string& user,
                             Diagnostics& diagnostics);

/// -1, and an error, when no module solves for it.
int find_field(const DofMap& dofs, const Located<std::string>& name, Diagnostics& diagnostics);

}  // namespace hawser
