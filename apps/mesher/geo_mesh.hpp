#pragma once
#include <string>
#include <utility>
#include <vector>

#include "gmsh_session.hpp"

namespace hawser::mesher {

struct GeoOptions {
  std::string file;                                     ///< in gmsh's language
  std::vector<std::pair<std::string, double>> numbers;  ///< in place of the file's own
  int refinements = 0;
  std::string output;
};

/// Meshes the plane and writes MSH 4.1. std::runtime_error with one sentence: what gmsh says of the
/// file, or which of the numbers the file does not define.
MeshSummary mesh_geo(const GeoOptions& options);

}  // namespace hawser::mesher
