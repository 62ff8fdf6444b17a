#pragma once
// The whole mesh as rank 0 prepares it: a Mesh whose local numbers are the rank-independent ones.
// Owners of vertices, edges and cells are not known yet and left empty.
#include <string>
#include <vector>

#include "hawser/mesh/mesh.hpp"
#include "msh_file.hpp"

namespace hawser {

/// A region without cells yet.
Region make_region(const std::string& name, CellShape shape);

/// Vertices, coordinates and the regions of the file, checked; triangles counter-clockwise. No
/// topology. MeshError.
Mesh check_and_number(const MshFile& file, int dimension);

/// Adds the body, edges, split vertices and the domains that are asked for. MeshError.
void add_topology(Mesh& mesh, const MeshOptions& options);

inline std::size_t at(LocalIndex index) { return static_cast<std::size_t>(index); }

/// Appends the entries of one cell to those of another list.
inline void append_cell(const std::vector<LocalIndex>& from, LocalIndex cell, int per_cell,
                        std::vector<LocalIndex>& to) {
  const auto begin = from.begin() + static_cast<std::ptrdiff_t>(cell) * per_cell;
  to.insert(to.end(), begin, begin + per_cell);
}

/// The same set of vertices is the same cell, wherever it begins.
std::vector<LocalIndex> sorted_vertices(const Region& region, LocalIndex cell);

/// "1 edge", "7 edges".
std::string counted(std::size_t count, const std::string& what);

/// "(x, y)" of a vertex, for messages.
std::string position_text(const Mesh& mesh, LocalIndex vertex);

/// The body, the named regions and what is derived from them, in an order that is that of every
/// part, too.
template <class AnyMesh>
auto all_regions(AnyMesh& mesh) {
  std::vector<decltype(&mesh.body)> all = {&mesh.body};
  for (auto& region : mesh.regions)
    all.push_back(&region);
  for (auto& derived : mesh.derived)
    all.push_back(&derived.second);
  return all;
}

}  // namespace hawser
