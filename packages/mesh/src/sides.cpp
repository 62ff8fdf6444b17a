// Sides of slits, from the connections of cells alone.
#include "sides.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "hawser/base/error.hpp"
#include "whole_mesh.hpp"

namespace hawser {
namespace {

std::vector<char> edges_of_slits(const Mesh& mesh, const std::vector<std::string>& slits) {
  std::vector<char> cut(mesh.edges.ids.size(), 0);
  for (const auto& name : slits) {
    const auto& region = mesh.region(name);
    if (region.shape != CellShape::line) {
      throw MeshError("the region '" + name + "' cannot be a slit, since it is no line region");
    }
    for (const auto edge : region.edges)
      cut[at(edge)] = 1;
  }
  return cut;
}

// At each vertex the fan of cells is cut by the slits' edges; corners of one connected part get
// one split vertex. Tips, lines that end on a wall, branches and cells that touch a line at one
// vertex need no case of their own. Never a geometric test: that fails as soon as a line bends.
class Parts {
 public:
  Parts(const Mesh& mesh, const EdgeSides& sides, const std::vector<char>& cut)
      : body_(mesh.body), parent_(mesh.body.vertices.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    std::vector<char> on_slit(mesh.vertices.ids.size(), 0);
    for (LocalIndex e = 0; e < mesh.edges.size(); ++e) {
      const LocalIndex ends[] = {mesh.edge_ends[at(2 * e)], mesh.edge_ends[at(2 * e + 1)]};
      for (const auto v : ends) {
        if (cut[at(e)]) {
          on_slit[at(v)] = 1;
        } else if (sides.count(e) == 2) {
          unite(corner(sides.left(e), v), corner(sides.right(e), v));
        }
      }
    }
    // Off the slits there is one split vertex, even where parts of the body meet in a single point.
    std::vector<LocalIndex> first(mesh.vertices.ids.size(), -1);
    for (LocalIndex c = 0; c < corners(); ++c) {
      const auto v = body_.vertices[at(c)];
      if (on_slit[at(v)]) continue;
      if (first[at(v)] < 0) first[at(v)] = c;
      unite(first[at(v)], c);
    }
  }

  // Like the vertices; the parts of one vertex by their first cell.
  void number(Mesh& mesh) {
    std::vector<std::pair<LocalIndex, LocalIndex>> parts;
    for (LocalIndex c = 0; c < corners(); ++c) {
      if (root(c) == c) parts.emplace_back(body_.vertices[at(c)], c);
    }
    std::sort(parts.begin(), parts.end());
    std::vector<LocalIndex> split_of_root(parent_.size(), -1);
    for (const auto& [vertex, c] : parts) {
      split_of_root[at(c)] = mesh.split_vertices.size();
      mesh.split_vertices.ids.push_back(mesh.split_vertices.size());
      mesh.vertex_of_split.push_back(vertex);
    }
    mesh.split_vertices.global_count = mesh.split_vertices.size();
    for (LocalIndex c = 0; c < corners(); ++c)
      mesh.body.split_vertices.push_back(split_of_root[at(root(c))]);
  }

 private:
  LocalIndex corners() const { return static_cast<LocalIndex>(parent_.size()); }

  LocalIndex corner(LocalIndex cell, LocalIndex v) const {
    LocalIndex c = cell * body_.vertices_per_cell;
    while (body_.vertices[at(c)] != v)
      ++c;
    return c;
  }

  LocalIndex root(LocalIndex c) {
    while (parent_[at(c)] != c) {
      c = parent_[at(c)] = parent_[at(parent_[at(c)])];
    }
    return c;
  }

  void unite(LocalIndex a, LocalIndex b) {
    a = root(a);
    b = root(b);
    parent_[at(std::max(a, b))] = std::min(a, b);
  }

  const Region& body_;
  std::vector<LocalIndex> parent_;  // of each corner; a root is its part's lowest corner
};

}  // namespace

void number_split_vertices(Mesh& mesh, const EdgeSides& sides,
                           const std::vector<std::string>& slits) {
  Parts(mesh, sides, edges_of_slits(mesh, slits)).number(mesh);
}

}  // namespace hawser
