#include "whole_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

class Numbering {
 public:
  Numbering(const MshFile& file, int dimension) : file_(file), dimension_(dimension) {}

  Mesh mesh() {
    sort_nodes();
    find_used_nodes();
    Mesh mesh;
    mesh.dimension = dimension_;
    add_vertices(mesh);
    add_regions(mesh);
    note_what_is_left_out(mesh);
    return mesh;
  }

 private:
  [[noreturn]] void fail(int line, const std::string& sentence) const {
    throw MeshError(file_.path + (line > 0 ? ":" + std::to_string(line) : "") + ": " + sentence);
  }

  static std::string name(const MshElement& element) {
    return "element " + std::to_string(element.tag);
  }

  // By their numbers in the file, so that the same mesh in another format or order of blocks is the
  // same mesh here.
  void sort_nodes() {
    nodes_ = file_.nodes;
    std::stable_sort(nodes_.begin(), nodes_.end(),
                     [](const MshNode& a, const MshNode& b) { return a.tag < b.tag; });
    const auto twice = std::adjacent_find(nodes_.begin(), nodes_.end(),
                                          [](auto& a, auto& b) { return a.tag == b.tag; });
    if (twice != nodes_.end()) {
      fail((twice + 1)->line, "node " + std::to_string(twice->tag) + " is defined twice");
    }
  }

  std::size_t place(const MshElement& element, long long tag) const {
    const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), tag,
                                        [](const MshNode& a, long long t) { return a.tag < t; });
    if (found == nodes_.end() || found->tag != tag) {
      fail(element.line, name(element) + " refers to node " + std::to_string(tag) +
                             ", which the file does not define");
    }
    return static_cast<std::size_t>(found - nodes_.begin());
  }

  // Nodes of no cell (centres of arcs, points of the geometry) are dropped: they would be empty
  // rows.
  void find_used_nodes() {
    vertex_of_node_.assign(nodes_.size(), -1);
    for (const auto& element : file_.elements) {
      const int n = traits(element.shape).vertices;
      for (int k = 0; k < n; ++k) {
        vertex_of_node_[place(element, element.nodes[static_cast<std::size_t>(k)])] = 0;
      }
    }
    LocalIndex count = 0;
    for (auto& vertex : vertex_of_node_) {
      if (vertex == 0) vertex = count++;
    }
  }

  void add_vertices(Mesh& mesh) const {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (vertex_of_node_[n] < 0) continue;
      const auto& position = nodes_[n].position;
      if (dimension_ == 2 && position[2] != 0) {
        fail(nodes_[n].line, "node " + std::to_string(nodes_[n].tag) +
                                 " lies off the plane z = 0; a mesh of lines in space is read with "
                                 "dimension=\"3\"");
      }
      mesh.coordinates.insert(mesh.coordinates.end(), position.begin(),
                              position.begin() + dimension_);
      mesh.vertices.ids.push_back(mesh.vertices.size());
    }
    mesh.vertices.global_count = mesh.vertices.size();
  }

  void note_what_is_left_out(Mesh& mesh) const {
    // Those of lower dimension are gmsh's own, when it saves all.
    if (const auto cells = file_.left_out[2]; cells > 0)
      mesh.notes.push_back(counted(static_cast<std::size_t>(cells), "triangle") +
                           " of the mesh file in no physical group left out; where they are "
                           "wanted, name their surface in gmsh (Physical Surface)");
    const auto nodes = std::count(vertex_of_node_.begin(), vertex_of_node_.end(), -1);
    if (nodes > 0)
      mesh.notes.push_back(counted(static_cast<std::size_t>(nodes), "node") +
                           " of the mesh file in no element of a physical group left out");
  }

  void add_regions(Mesh& mesh) {
    for (const auto& group : file_.groups) {
      const int greatest = dimension_ == 2 ? 2 : 1;
      if (group.dimension < 0 || group.dimension > greatest) {
        throw MeshError(file_.path + ": the physical group '" + group.name + "' has dimension " +
                        std::to_string(group.dimension) + "; " +
                        (dimension_ == 2 ? "only 0, 1 and 2 are read"
                                         : "in space only points and lines are read"));
      }
      mesh.regions.push_back(make_region(group.name, CellShape::point));  // until its first cell
    }
    elements_.resize(mesh.regions.size());
    for (const auto& element : file_.elements) {
      auto& region = mesh.regions[static_cast<std::size_t>(element.group)];
      elements_[static_cast<std::size_t>(element.group)].push_back(&element);
      if (region.size() == 0) region = make_region(region.name, element.shape);
      if (region.shape != element.shape)
        fail(element.line, name(element) + " makes '" + region.name + "' a group of both " +
                               traits(region.shape).plural + " and " +
                               traits(element.shape).plural + "; each must have its own");
      region.cell_ids.push_back(region.size());
      add_cell(mesh, region, element);
    }
    std::vector<Region> filled;
    for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
      if (mesh.regions[r].size() == 0) {
        mesh.notes.push_back("physical group '" + mesh.regions[r].name +
                             "' of the mesh file has no elements and is left out");
        continue;
      }
      refuse_repetition(mesh.regions[r], elements_[r]);
      filled.push_back(std::move(mesh.regions[r]));
    }
    mesh.regions = std::move(filled);
  }

  void add_cell(const Mesh& mesh, Region& region, const MshElement& element) {
    std::vector<LocalIndex> cell;
    for (int k = 0; k < region.vertices_per_cell; ++k) {
      const auto tag = element.nodes[static_cast<std::size_t>(k)];
      const auto vertex = vertex_of_node_[place(element, tag)];
      if (std::find(cell.begin(), cell.end(), vertex) != cell.end()) {
        fail(element.line, name(element) + " names node " + std::to_string(tag) + " twice");
      }
      cell.push_back(vertex);
    }
    if (region.dimension == 2) {
      double least = 1, most = -1;  // of the triangles at the corners
      const auto x = [&](std::size_t k) {
        return &mesh.coordinates[2 * std::size_t(cell[k % cell.size()])];
      };
      for (std::size_t k = 0; k < cell.size(); ++k) {
        const double quality = triangle_quality(x(k), x(k + 1), x(k + 2));
        least = std::min(least, quality);
        most = std::max(most, quality);
      }
      // Far below what any mesher writes, far above the round-off of three points on a line.
      constexpr double flat = 1e-10;
      if (least < flat && most > -flat)
        fail(element.line, name(element) + " of '" + region.name + "' is flat or folded over");
      if (most < 0) std::reverse(cell.begin() + 1, cell.end());
    }
    region.vertices.insert(region.vertices.end(), cell.begin(), cell.end());
  }

  void refuse_repetition(const Region& region,
                         const std::vector<const MshElement*>& elements) const {
    std::vector<std::pair<std::vector<LocalIndex>, std::size_t>> cells;
    for (std::size_t c = 0; c < elements.size(); ++c)
      cells.emplace_back(sorted_vertices(region, static_cast<LocalIndex>(c)), c);
    std::sort(cells.begin(), cells.end());
    for (std::size_t c = 1; c < cells.size(); ++c) {
      if (cells[c].first != cells[c - 1].first) continue;
      const auto& again = *elements[cells[c].second];
      fail(again.line, name(again) + " of '" + region.name + "' has the same nodes as " +
                           name(*elements[cells[c - 1].second]));
    }
  }

  const MshFile& file_;
  int dimension_;
  std::vector<MshNode> nodes_;                            // by number
  std::vector<LocalIndex> vertex_of_node_;                // -1: dropped
  std::vector<std::vector<const MshElement*>> elements_;  // per region, for messages
};

}  // namespace

Region make_region(const std::string& name, CellShape shape) {
  Region region;
  region.name = name;
  region.shape = shape;
  region.dimension = traits(shape).dimension;
  region.vertices_per_cell = traits(shape).vertices;
  region.edges_per_cell = traits(shape).edges;
  return region;
}

std::vector<LocalIndex> sorted_vertices(const Region& region, LocalIndex cell) {
  std::vector<LocalIndex> vertices;
  append_cell(region.vertices, cell, region.vertices_per_cell, vertices);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string position_text(const Mesh& mesh, LocalIndex vertex) {
  std::ostringstream text;
  for (int j = 0; j < mesh.dimension; ++j)
    text << (j == 0 ? "(" : ", ") << mesh.coordinates[at(mesh.dimension * vertex + j)];
  return text.str() + ")";
}

Mesh check_and_number(const MshFile& file, int dimension) {
  return Numbering(file, dimension).mesh();
}

}  // namespace hawser
