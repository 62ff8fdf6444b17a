// Edges, sides of slits, patches and facets, from the connections of cells alone.
#include <algorithm>
#include <array>
#include <numeric>
#include <sstream>
#include <tuple>
#include <utility>

#include "hawser/base/error.hpp"
#include "whole_mesh.hpp"

namespace hawser {
namespace {

using Ends = std::pair<LocalIndex, LocalIndex>;

std::size_t at(LocalIndex index) { return static_cast<std::size_t>(index); }

Ends sorted(LocalIndex a, LocalIndex b) { return {std::min(a, b), std::max(a, b)}; }

// Numbers the edges of all triangles and lines in the order of their ends.
void number_edges(Mesh& mesh) {
  const auto each_edge = [&](auto&& visit) {
    for (auto& region : mesh.regions) {
      const int n = region.vertices_per_cell;
      for (LocalIndex c = 0; c < region.size(); ++c) {
        const auto* v = &region.vertices[at(n * c)];
        for (int k = 0; k < region.edges_per_cell; ++k) {
          const auto& ends = traits(region.shape).edge[k];
          visit(region, sorted(v[ends[0]], v[ends[1]]));
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

// The body: every triangle once, however many regions name it.
class Body {
 public:
  explicit Body(const Mesh& mesh) : mesh_(mesh), triangles_of_edge_(mesh.edge_ends.size(), -1) {
    for (const auto& region : mesh.regions) {
      if (region.shape != CellShape::triangle) continue;
      for (LocalIndex c = 0; c < region.size(); ++c)
        add(region, c);
    }
  }

  LocalIndex size() const { return static_cast<LocalIndex>(vertices_.size()) / 3; }
  LocalIndex vertex(LocalIndex corner) const { return vertices_[at(corner)]; }
  LocalIndex edge(LocalIndex corner) const { return edges_[at(corner)]; }  ///< to the next corner

  int count_at_edge(LocalIndex edge) const { return (left(edge) >= 0) + (right(edge) >= 0); }
  LocalIndex left(LocalIndex edge) const { return triangles_of_edge_[at(2 * edge)]; }
  LocalIndex right(LocalIndex edge) const { return triangles_of_edge_[at(2 * edge + 1)]; }

  LocalIndex corner(LocalIndex triangle, LocalIndex v) const {
    LocalIndex k = 3 * triangle;
    while (vertex(k) != v)
      ++k;
    return k;
  }

  /// The triangle of three edges, or -1.
  LocalIndex find(const LocalIndex* e) const {
    for (const auto t : {left(e[0]), right(e[0])}) {
      if (t < 0) continue;
      const auto* own = &edges_[at(3 * t)];
      if (std::is_permutation(e, e + 3, own)) return t;
    }
    return -1;
  }

 private:
  void add(const Region& region, LocalIndex cell) {
    const auto* v = &region.vertices[at(3 * cell)];
    const auto* e = &region.edges[at(3 * cell)];
    if (find(e) >= 0) return;
    const LocalIndex triangle = size();
    vertices_.insert(vertices_.end(), v, v + 3);
    edges_.insert(edges_.end(), e, e + 3);
    for (int k = 0; k < 3; ++k) {
      // Counter-clockwise triangles on either side of an edge run along it in opposite directions.
      auto& place = triangles_of_edge_[at(2 * e[k] + (v[k] < v[(k + 1) % 3] ? 0 : 1))];
      if (place >= 0) {
        const auto* x = &mesh_.coordinates[at(2 * v[k])];
        const auto* y = &mesh_.coordinates[at(2 * v[(k + 1) % 3])];
        std::ostringstream where;
        where << "(" << x[0] << ", " << x[1] << ") to (" << y[0] << ", " << y[1] << ")";
        throw MeshError("two triangles overlap on the same side of the edge from " + where.str());
      }
      place = triangle;
    }
  }

  const Mesh& mesh_;
  std::vector<LocalIndex> vertices_, edges_;   // [triangle][3]
  std::vector<LocalIndex> triangles_of_edge_;  // [edge][2]: left and right of lower -> higher end
};

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

// At each vertex the fan of triangles is cut by the slits' edges; corners of one connected part get
// one split vertex. Tips, lines that end on a wall, branches and triangles that touch a line at one
// vertex need no case of their own. Never a geometric test: that fails as soon as a line bends.
class Sides {
 public:
  Sides(const Body& body, const Mesh& mesh, const std::vector<char>& cut)
      : body_(body), parent_(at(3 * body.size())) {
    std::iota(parent_.begin(), parent_.end(), 0);
    std::vector<char> on_slit(mesh.vertices.ids.size(), 0);
    for (LocalIndex e = 0; e < mesh.edges.size(); ++e) {
      const LocalIndex ends[] = {mesh.edge_ends[at(2 * e)], mesh.edge_ends[at(2 * e + 1)]};
      for (const auto v : ends) {
        if (cut[at(e)]) {
          on_slit[at(v)] = 1;
        } else if (body.count_at_edge(e) == 2) {
          unite(body.corner(body.left(e), v), body.corner(body.right(e), v));
        }
      }
    }
    // Off the slits there is one split vertex, even where parts of the body meet in a single point.
    std::vector<LocalIndex> first(mesh.vertices.ids.size(), -1);
    for (LocalIndex corner = 0; corner < 3 * body.size(); ++corner) {
      const auto v = body.vertex(corner);
      if (on_slit[at(v)]) continue;
      if (first[at(v)] < 0) first[at(v)] = corner;
      unite(first[at(v)], corner);
    }
    number();
  }

  const std::vector<LocalIndex>& vertex_of_split() const { return vertex_of_split_; }
  LocalIndex split(LocalIndex corner) { return split_of_root_[at(root(corner))]; }

 private:
  LocalIndex root(LocalIndex corner) {
    while (parent_[at(corner)] != corner) {
      corner = parent_[at(corner)] = parent_[at(parent_[at(corner)])];
    }
    return corner;
  }

  void unite(LocalIndex a, LocalIndex b) {
    a = root(a);
    b = root(b);
    parent_[at(std::max(a, b))] = std::min(a, b);
  }

  // Like the vertices; the parts of one vertex by their first triangle.
  void number() {
    std::vector<std::pair<LocalIndex, LocalIndex>> parts;
    for (LocalIndex corner = 0; corner < 3 * body_.size(); ++corner) {
      if (root(corner) == corner) parts.emplace_back(body_.vertex(corner), corner);
    }
    std::sort(parts.begin(), parts.end());
    split_of_root_.assign(parent_.size(), -1);
    for (const auto& [vertex, corner] : parts) {
      split_of_root_[at(corner)] = static_cast<LocalIndex>(vertex_of_split_.size());
      vertex_of_split_.push_back(vertex);
    }
  }

  const Body& body_;
  std::vector<LocalIndex> parent_;  // of each corner; a root is its part's lowest corner
  std::vector<LocalIndex> split_of_root_, vertex_of_split_;
};

void number_split_vertices(Mesh& mesh, const Body& body, Sides& sides) {
  mesh.vertex_of_split = sides.vertex_of_split();
  mesh.split_vertices.ids.resize(mesh.vertex_of_split.size());
  std::iota(mesh.split_vertices.ids.begin(), mesh.split_vertices.ids.end(), 0);
  mesh.split_vertices.global_count = mesh.split_vertices.size();
  for (auto& region : mesh.regions) {
    if (region.shape != CellShape::triangle) continue;
    for (LocalIndex corner = 0; corner < 3 * region.size(); ++corner) {
      const auto triangle = body.find(&region.edges[at(corner / 3 * 3)]);
      const auto vertex = region.vertices[at(corner)];
      region.split_vertices.push_back(sides.split(body.corner(triangle, vertex)));
    }
  }
}

// Turned so that its first edge is the line: the body, being on the left of every edge of a
// counter-clockwise triangle, is on the left of this one.
Region facets_of(const Region& line, const Body& body, Sides& sides) {
  auto facets = make_region(line.name + "/facets", CellShape::facet);
  for (const auto edge : line.edges) {
    if (body.count_at_edge(edge) != 1) continue;
    const auto triangle = std::max(body.left(edge), body.right(edge));
    LocalIndex first = 0;
    while (body.edge(3 * triangle + first) != edge)
      ++first;
    facets.cell_ids.push_back(facets.size());
    for (LocalIndex k = first; k < first + 3; ++k) {
      const LocalIndex corner = 3 * triangle + k % 3;
      facets.vertices.push_back(body.vertex(corner));
      facets.split_vertices.push_back(sides.split(corner));
      facets.edges.push_back(body.edge(corner));
    }
  }
  return facets;
}

Region patches_of(const Region& line, const Body& body) {
  struct Neighbour {
    LocalIndex vertex, other;
    bool after;  // the line cell runs from vertex to other
  };
  std::vector<Neighbour> neighbours;
  for (LocalIndex c = 0; c < line.size(); ++c) {
    if (body.count_at_edge(line.edges[at(c)]) == 1) continue;
    const auto a = line.vertices[at(2 * c)], b = line.vertices[at(2 * c + 1)];
    neighbours.push_back({a, b, true});
    neighbours.push_back({b, a, false});
  }
  // Along the line where its cells agree on a direction, else the lower vertex first.
  std::sort(neighbours.begin(), neighbours.end(), [](const Neighbour& p, const Neighbour& q) {
    return std::tie(p.vertex, p.after, p.other) < std::tie(q.vertex, q.after, q.other);
  });
  auto patches = make_region(line.name + "/patches", CellShape::patch);
  for (std::size_t i = 0, end = 0; i < neighbours.size(); i = end) {
    while (end < neighbours.size() && neighbours[end].vertex == neighbours[i].vertex)
      ++end;
    if (end - i != 2) continue;  // an end of the line or a branch
    patches.cell_ids.push_back(patches.size());
    patches.vertices.insert(patches.vertices.end(),
                            {neighbours[i].other, neighbours[i].vertex, neighbours[i + 1].other});
  }
  return patches;
}

// The line's cells at a point region, each turned to begin there. Empty where they do not touch.
Region cells_at(const Region& point, const Region& line) {
  auto result = make_region(line.name + "/" + point.name, CellShape::line);
  for (LocalIndex c = 0; c < line.size(); ++c)
    for (const std::size_t end : {0U, 1U}) {
      const auto here = line.vertices[at(2 * c) + end], there = line.vertices[at(2 * c) + 1 - end];
      if (std::find(point.vertices.begin(), point.vertices.end(), here) == point.vertices.end())
        continue;
      result.cell_ids.push_back(result.size());
      result.vertices.insert(result.vertices.end(), {here, there});
      result.edges.push_back(line.edges[at(c)]);
    }
  return result;
}

}  // namespace

void add_topology(Mesh& mesh, const std::vector<std::string>& slits) {
  number_edges(mesh);
  const Body body(mesh);
  Sides sides(body, mesh, edges_of_slits(mesh, slits));
  number_split_vertices(mesh, body, sides);
  std::vector<Region> derived;
  for (const auto& region : mesh.regions) {
    if (region.shape != CellShape::line) continue;
    const auto on_boundary = [&](LocalIndex edge) { return body.count_at_edge(edge) == 1; };
    const auto& edges = region.edges;
    if (!std::all_of(edges.begin(), edges.end(), on_boundary)) {
      derived.push_back(patches_of(region, body));
      for (const auto& point : mesh.regions) {
        if (point.shape != CellShape::point) continue;
        auto cells = cells_at(point, region);
        if (cells.size() > 0) derived.push_back(std::move(cells));
      }
    }
    if (std::any_of(edges.begin(), edges.end(), on_boundary)) {
      derived.push_back(facets_of(region, body, sides));
    }
  }
  mesh.regions.insert(mesh.regions.end(), derived.begin(), derived.end());
}

}  // namespace hawser
