// Edges, and what follows from them: sides of slits, derived domains.
#include <algorithm>
#include <utility>

#include "body.hpp"
#include "derive.hpp"
#include "sides.hpp"
#include "whole_mesh.hpp"

namespace hawser {
namespace {

using Ends = std::pair<LocalIndex, LocalIndex>;

// Numbers the edges of the body and of all lines in the order of their ends.
void number_edges(Mesh& mesh) {
  const auto each_edge = [&](auto&& visit) {
    for (auto* region : all_regions(mesh)) {
      const int n = region->vertices_per_cell;
      if (region != &mesh.body && region->dimension == mesh.body.dimension) continue;
      for (LocalIndex c = 0; c < region->size(); ++c) {
        const auto* v = &region->vertices[at(n * c)];
        for (int k = 0; k < region->edges_per_cell; ++k) {
          const auto& ends = traits(region->shape).edge[k];
          visit(*region, std::minmax(v[ends[0]], v[ends[1]]));
        }
      }
    }
  };
  std::vector<Ends> edges;
  each_edge([&](Region&, const Ends& ends) { edges.push_back(ends); });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) {
    mesh.edges.ids.push_back(mesh.edges.size());
    mesh.edge_ends.insert(mesh.edge_ends.end(), {a, b});
  }
  mesh.edges.global_count = mesh.edges.size();
  each_edge([&](Region& region, const Ends& ends) {
    const auto found = std::lower_bound(edges.begin(), edges.end(), ends);
    region.edges.push_back(static_cast<LocalIndex>(found - edges.begin()));
  });
}

}  // namespace

void add_topology(Mesh& mesh, const MeshOptions& options) {
  unite_body(mesh);
  number_edges(mesh);
  const EdgeSides sides(mesh);
  number_split_vertices(mesh, sides, options.slits);
  for (auto& region : mesh.regions)
    if (region.dimension == mesh.dimension) copy_from_body(mesh.body, region);
  derive(mesh, sides, options.domains);
}

}  // namespace hawser
