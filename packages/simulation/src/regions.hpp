#pragma once
#include <string>

#include "hawser/deck/diagnostics.hpp"
#include "hawser/mesh/mesh.hpp"

namespace hawser {

/// The region of that name, or null and an error that names those there are.
const Region* find_region(const Mesh& mesh, const std::string& name, const Location& where,
                          Diagnostics& diagnostics);
inline const Region* find_region(const Mesh& mesh, const Located<std::string>& name,
                                 Diagnostics& diagnostics) {
  return find_region(mesh, name.value, name.location, diagnostics);
}

}  // namespace hawser
