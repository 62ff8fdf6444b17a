// Unions of regions, facets, patches and ends.
#include "derive.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "hawser/base/error.hpp"
#include "whole_mesh.hpp"

namespace hawser {
namespace {

// Without cells where a region is missing or of another shape than the first.
Region union_of(const Mesh& mesh, const Domain& domain) {
  Region all;
  std::set<std::vector<LocalIndex>> seen;  // sorted vertices
  for (const auto& name : domain.regions) {
    const Region* const region = mesh.find(name);
    if (region == nullptr || (all.size() > 0 && region->shape != all.shape)) return {};
    if (all.size() == 0) all = make_region(domain.text(), region->shape);
    if (all.dimension == mesh.dimension) {
      all.cell_ids.insert(all.cell_ids.end(), region->cell_ids.begin(), region->cell_ids.end());
      continue;
    }
    for (LocalIndex c = 0; c < region->size(); ++c) {
      if (!seen.insert(sorted_vertices(*region, c)).second) continue;
      all.cell_ids.push_back(all.size());
      append_cell(region->vertices, c, all.vertices_per_cell, all.vertices);
      append_cell(region->edges, c, all.edges_per_cell, all.edges);
    }
  }
  if (all.dimension == mesh.dimension) {
    std::sort(all.cell_ids.begin(), all.cell_ids.end());
    all.cell_ids.erase(std::unique(all.cell_ids.begin(), all.cell_ids.end()), all.cell_ids.end());
    copy_from_body(mesh.body, all);
  }
  return all;
}

// Turned so that its first edge is the line: the body, being on the left of every edge of a
// counter-clockwise cell, is on the left of this one.
Region facets_of(const Mesh& mesh, const Region& line, const EdgeSides& sides) {
  const auto& body = mesh.body;
  auto facets = make_region(line.name, body.shape);
  facets.dimension = line.dimension;
  const int n = body.vertices_per_cell;
  for (const auto edge : line.edges) {
    if (!sides.on_boundary(edge)) continue;
    const auto first = n * std::max(sides.left(edge), sides.right(edge));
    LocalIndex turn = 0;
    while (body.edges[at(first + turn)] != edge)
      ++turn;
    facets.cell_ids.push_back(facets.size());
    for (LocalIndex k = turn; k < turn + n; ++k) {
      const auto corner = at(first + k % n);
      facets.vertices.push_back(body.vertices[corner]);
      facets.split_vertices.push_back(body.split_vertices[corner]);
      facets.edges.push_back(body.edges[corner]);
    }
  }
  return facets;
}

std::string names(const Domain& domain) { return Domain(domain.regions).text(); }

Region patches_of(const Mesh& mesh, const Region& line, const Domain& domain) {
  struct Neighbour {
    LocalIndex vertex, other;
    bool after;  // the line cell runs from vertex to other
  };
  std::vector<Neighbour> neighbours;
  for (LocalIndex c = 0; c < line.size(); ++c) {
    const auto a = line.vertices[at(2 * c)], b = line.vertices[at(2 * c + 1)];
    neighbours.push_back({a, b, true});
    neighbours.push_back({b, a, false});
  }
  // Along the line where its cells agree on a direction, else the lower vertex first.
  std::sort(neighbours.begin(), neighbours.end(), [](const Neighbour& p, const Neighbour& q) {
    return std::tie(p.vertex, p.after, p.other) < std::tie(q.vertex, q.after, q.other);
  });
  auto patches = make_region(line.name, CellShape::line);
  patches.vertices_per_cell = 3;
  patches.edges_per_cell = 0;
  for (std::size_t i = 0, end = 0; i < neighbours.size(); i = end) {
    while (end < neighbours.size() && neighbours[end].vertex == neighbours[i].vertex)
      ++end;
    if (end - i > 2)
      throw MeshError("the line of '" + names(domain) + "' branches at " +
                      position_text(mesh, neighbours[i].vertex) +
                      ", where there is no saying which of its segments bend together; name the "
                      "line that runs through and the one that is hinged to it apart");
    if (end - i < 2) continue;  // an end of the line
    patches.cell_ids.push_back(patches.size());
    patches.vertices.insert(patches.vertices.end(),
                            {neighbours[i].other, neighbours[i].vertex, neighbours[i + 1].other});
  }
  return patches;
}

Region ends_of(const Mesh& mesh, const Region& line, const std::string& point_name) {
  auto ends = make_region(line.name, CellShape::line);
  const Region* const point = mesh.find(point_name);
  if (point == nullptr) return ends;
  for (LocalIndex c = 0; c < line.size(); ++c)
    for (const std::size_t end : {0U, 1U}) {
      const auto here = line.vertices[at(2 * c) + end], there = line.vertices[at(2 * c) + 1 - end];
      if (std::find(point->vertices.begin(), point->vertices.end(), here) == point->vertices.end())
        continue;
      ends.cell_ids.push_back(ends.size());
      ends.vertices.insert(ends.vertices.end(), {here, there});
      ends.edges.push_back(line.edges[at(c)]);
    }
  return ends;
}

Region make(const Mesh& mesh, const EdgeSides& sides, const Domain& domain) {
  Region all = union_of(mesh, domain);
  if (domain.kind == Domain::Kind::cells) return all;
  if (all.shape != CellShape::line) return {};
  if (domain.kind == Domain::Kind::facets) return facets_of(mesh, all, sides);
  if (domain.kind == Domain::Kind::patches) return patches_of(mesh, all, domain);
  return ends_of(mesh, all, domain.point);
}

std::set<LocalIndex> nodes(const Region& region) {
  return {region.vertices.begin(), region.vertices.end()};
}

// Lines that are bent by modules of their own turn freely about the nodes they share.
void note_hinges(Mesh& mesh) {
  for (const auto& [domain, patches] : mesh.derived)
    for (const auto& [other_domain, others] : mesh.derived) {
      if (&patches == &others) break;
      if (domain.kind != Domain::Kind::patches || other_domain.kind != Domain::Kind::patches)
        continue;
      const auto there = nodes(others);
      for (const auto v : nodes(patches))
        if (there.count(v) > 0)
          mesh.notes.push_back("the lines of '" + names(other_domain) + "' and '" + names(domain) +
                               "' are hinged to each other at " + position_text(mesh, v) +
                               "; to bend together there, they must be of one module");
    }
}

}  // namespace

void derive(Mesh& mesh, const EdgeSides& sides, const std::vector<Domain>& domains) {
  for (const auto& domain : domains) {
    if (mesh.find(domain) != nullptr) continue;
    Region region = make(mesh, sides, domain);
    if (region.size() > 0) mesh.derived.emplace_back(domain, std::move(region));
  }
  note_hinges(mesh);
}

}  // namespace hawser
