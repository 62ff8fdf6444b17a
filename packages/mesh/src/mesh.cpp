#include "hawser/mesh/mesh.hpp"

#include <algorithm>

#include "distribute.hpp"
#include "graph.hpp"
#include "hawser/base/error.hpp"
#include "whole_mesh.hpp"

namespace hawser {

bool Mesh::has_body() const {
  return std::any_of(regions.begin(), regions.end(),
                     [](const Region& region) { return region.shape == CellShape::triangle; });
}

const char* Mesh::per_depth() const { return dimension == 2 && has_body() ? "/m" : ""; }

const Region* Mesh::find(const std::string& name) const {
  for (const auto& region : regions) {
    if (region.name == name) return &region;
  }
  return nullptr;
}

const Region& Mesh::region(const std::string& name) const {
  if (const auto* found = find(name)) return *found;
  std::string names;
  for (const auto& region : regions)
    names += (names.empty() ? "" : ", ") + region.name;
  throw MeshError("the mesh has no region '" + name + "'; it has " + names);
}

Mesh read_mesh(const Communicator& communicator, const MeshOptions& options) {
  Mesh whole;
  whole.communicator = communicator;
  std::vector<int> owner_of_vertex;
  communicator.on_root([&] {
    whole = check_and_number(read_msh(options.file), options.dimension);
    whole.communicator = communicator;
    add_topology(whole, options.slits);
    const auto graph = make_graph(whole.vertices.size(), whole.edge_ends);
    owner_of_vertex = partition(graph, communicator.size());
  });
  return distribute(communicator, whole, owner_of_vertex);
}

}  // namespace hawser
