#pragma once
// What both ways of meshing do with gmsh.
#include <cstddef>
#include <string>

namespace hawser::mesher {

struct MeshSummary {
  std::size_t nodes = 0, triangles = 0, segments = 0;
  double least_quality = 1, mean_quality = 0;
};

/// Starts and stops gmsh, also when something is thrown: silent, on one thread, with the same mesh
/// on every machine.
struct GmshSession {
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
};

/// Cuts every cell into four as often, and writes MSH 4.1. std::runtime_error with one sentence.
void refine_and_write(int refinements, const std::string& path);

/// Of the triangles of the present model.
MeshSummary measure();

}  // namespace hawser::mesher
