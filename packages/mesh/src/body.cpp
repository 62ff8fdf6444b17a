#include "body.hpp"

#include <algorithm>
#include <map>

#include "hawser/base/error.hpp"
#include "whole_mesh.hpp"

namespace hawser {

void unite_body(Mesh& mesh) {
  std::map<std::vector<LocalIndex>, GlobalIndex> number_of;  // by the sorted vertices
  for (auto& region : mesh.regions) {
    if (region.dimension < mesh.dimension) continue;
    if (mesh.body.size() == 0) mesh.body = make_region("body", region.shape);
    if (region.shape != mesh.body.shape)
      throw MeshError("the mesh is of both " + std::string(traits(mesh.body.shape).plural) +
                      " and " + traits(region.shape).plural + "; a body has cells of one shape");
    for (LocalIndex c = 0; c < region.size(); ++c) {
      const auto [place, fresh] = number_of.emplace(sorted_vertices(region, c), mesh.body.size());
      if (fresh) {
        mesh.body.cell_ids.push_back(mesh.body.size());
        append_cell(region.vertices, c, region.vertices_per_cell, mesh.body.vertices);
      }
      region.cell_ids[at(c)] = place->second;
    }
    std::sort(region.cell_ids.begin(), region.cell_ids.end());
  }
}

void copy_from_body(const Region& body, Region& region) {
  const auto copy = [&](const std::vector<LocalIndex>& from, int per_cell,
                        std::vector<LocalIndex>& to) {
    to.clear();
    for (const auto id : region.cell_ids)
      append_cell(from, static_cast<LocalIndex>(id), per_cell, to);
  };
  copy(body.vertices, body.vertices_per_cell, region.vertices);
  copy(body.split_vertices, body.vertices_per_cell, region.split_vertices);
  copy(body.edges, body.edges_per_cell, region.edges);
}

EdgeSides::EdgeSides(const Mesh& mesh) : cells_(mesh.edge_ends.size(), -1) {
  const auto& body = mesh.body;
  for (LocalIndex c = 0; c < body.size(); ++c)
    for (int k = 0; k < body.edges_per_cell; ++k) {
      const auto edge = body.edges[at(c * body.edges_per_cell + k)];
      const auto start = body.vertices[at(c * body.vertices_per_cell + k)];
      const auto* const ends = &mesh.edge_ends[at(2 * edge)];
      // Counter-clockwise cells on either side of an edge run along it in opposite directions.
      auto& place = cells_[at(2 * edge + (start == ends[0] ? 0 : 1))];
      if (place >= 0)
        throw MeshError("two cells overlap on the same side of the edge from " +
                        position_text(mesh, start) + " to " +
                        position_text(mesh, ends[start == ends[0] ? 1 : 0]));
      place = c;
    }
}

}  // namespace hawser
