#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <utility>

#include "audit_findings.hpp"
#include "body_parts.hpp"
#include "coincident.hpp"
#include "hanging.hpp"
#include "hawser/mesh/mesh_audit.hpp"
#include "line_pieces.hpp"
#include "whole_mesh.hpp"

namespace hawser {
namespace {

class Audit {
 public:
  Audit(const Mesh& mesh, const MeshOptions& options)
      : mesh_(mesh),
        options_(options),
        found_(mesh),
        sides_(mesh),
        apart_(mesh.vertices.ids.size(), 0) {
    for (const auto& name : options.apart)
      for (const auto v : mesh.region(name).vertices)
        apart_[at(v)] = 1;
    on_body_.assign(apart_.size(), 0);
    for (const auto v : mesh.body.vertices)
      on_body_[at(v)] = 1;
  }

  std::vector<MeshFinding> findings() {
    look_at_edges();
    look_at_coincident_nodes();
    look_at_points();
    if (!mesh_.has_body()) return found_.all();
    look_at_lines();
    look_at_hanging_nodes();
    look_at_boundary();
    look_at_modules();
    look_at_parts();
    look_at_quality();
    return found_.all();
  }

 private:
  bool is_apart(const std::string& region) const {
    return std::find(options_.apart.begin(), options_.apart.end(), region) != options_.apart.end();
  }

  void look_at_edges() {
    double low[3], high[3], squared = 0;
    for (int j = 0; j < mesh_.dimension; ++j) {
      low[j] = std::numeric_limits<double>::max();
      high[j] = -low[j];
      for (LocalIndex v = 0; v < mesh_.vertices.size(); ++v) {
        low[j] = std::min(low[j], coordinate(v, j));
        high[j] = std::max(high[j], coordinate(v, j));
      }
      squared += (high[j] - low[j]) * (high[j] - low[j]);
    }
    const double no_length = 1e-9 * std::sqrt(squared);
    std::vector<LocalIndex> points;
    for (LocalIndex e = 0; e < mesh_.edges.size(); ++e) {
      const double length = edge_length(mesh_, e);
      if (length > no_length)
        shortest_ = std::min(shortest_, length);
      else
        points.push_back(mesh_.edge_ends[at(2 * e)]);
    }
    if (points.empty()) return;
    found_.error(counted(points.size(), "edge") + " of " + found_.regions_at(points) +
                 (points.size() == 1 ? " has" : " have") + " no length, " + found_.places(points) +
                 "; merge the nodes in gmsh (Coherence Mesh)");
  }

  // Without a common node there is a wall that nobody sees, or a cable that nothing holds.
  void look_at_coincident_nodes() {
    if (!std::isfinite(shortest_)) return;
    std::vector<LocalIndex> lower, both;
    for (const auto& [a, b] : coincident_vertices(mesh_, 0.01 * shortest_, shortest_)) {
      if (apart_[at(a)] || apart_[at(b)] || joined(a, b)) continue;
      if (lower.empty() || lower.back() != a) lower.push_back(a);
      both.insert(both.end(), {a, b});
    }
    if (lower.empty()) return;
    found_.error("the mesh has several nodes at one place, at " + counted(lower.size(), "place") +
                 ": " + found_.places(lower) + " in " + found_.regions_at(both) +
                 "; nothing passes from one to the other. Join what meets there in gmsh "
                 "(BooleanFragments, Coherence, or a last line 'Coherence Mesh;'), or name in "
                 "<mesh apart=\"...\"> the region that is meant to be apart");
  }

  void look_at_hanging_nodes() {
    if (!std::isfinite(shortest_)) return;
    auto hanging = hanging_vertices(mesh_, sides_, 0.01 * shortest_);
    hanging.erase(std::remove_if(hanging.begin(), hanging.end(),
                                 [&](LocalIndex v) { return apart_[at(v)] != 0; }),
                  hanging.end());
    if (!hanging.empty())
      found_.error(counted(hanging.size(), "node") + " of the boundary " +
                   (hanging.size() == 1 ? "lies" : "lie") +
                   " on edges of it that do not end there, " + found_.places(hanging) + " in " +
                   found_.regions_at(hanging) +
                   "; nothing passes there. Let what meets there have the same nodes in gmsh "
                   "(BooleanFragments, or one curve for both surfaces), or name in <mesh "
                   "apart=\"...\"> the region that is meant to be apart");
  }

  /// By an edge, which look_at_edges() has told of.
  bool joined(LocalIndex a, LocalIndex b) const {
    const auto first = std::pair(std::min(a, b), std::max(a, b));
    LocalIndex low = 0, high = mesh_.edges.size();  // edges are in the order of their ends
    while (low < high) {
      const auto middle = low + (high - low) / 2;
      if (ends(middle) < first)
        low = middle + 1;
      else
        high = middle;
    }
    return low < mesh_.edges.size() && ends(low) == first;
  }
  std::pair<LocalIndex, LocalIndex> ends(LocalIndex edge) const {
    return {mesh_.edge_ends[at(2 * edge)], mesh_.edge_ends[at(2 * edge + 1)]};
  }

  void look_at_points() {
    std::vector<char> held = on_body_;
    for (const auto& region : mesh_.regions)
      if (region.shape != CellShape::point)
        for (const auto v : region.vertices)
          held[at(v)] = 1;
    for (const auto& region : mesh_.regions) {
      if (region.shape != CellShape::point || is_apart(region.name)) continue;
      std::vector<LocalIndex> loose;
      for (const auto v : region.vertices)
        if (!held[at(v)]) loose.push_back(v);
      if (!loose.empty())
        found_.note(counted(loose.size(), "node") + " of '" + region.name + "' " +
                    (loose.size() == 1 ? "belongs" : "belong") + " to no line and no cell, " +
                    found_.places(loose) + "; in gmsh: Point{...} In Surface{...}");
    }
  }

  /// Line regions on which a module or a slit lives.
  std::set<std::string> used_lines() const {
    std::set<std::string> used(options_.slits.begin(), options_.slits.end());
    for (const auto& domain : options_.domains)
      used.insert(domain.regions.begin(), domain.regions.end());
    return used;
  }

  void look_at_lines() {
    const auto used = used_lines();
    for (const auto& region : mesh_.regions) {
      if (region.shape != CellShape::line || is_apart(region.name)) continue;
      std::vector<LocalIndex> beside;
      for (const auto edge : region.edges)
        if (sides_.count(edge) == 0) beside.push_back(edge);
      if (beside.empty()) continue;
      const std::string what = std::to_string(beside.size()) + " of the " +
                               counted(region.edges.size(), "edge") + " of '" + region.name + "' " +
                               (beside.size() == 1 ? "belongs" : "belong") +
                               " to no cell of the body: " + found_.pieces(beside);
      if (used.count(region.name) == 0)
        found_.note(what + "; what is prescribed there is not prescribed to the body");
      else
        found_.error(what +
                     "; neither feels the other. Embed the line in gmsh (Curve{...} In "
                     "Surface{...}, or BooleanFragments), or say <mesh apart=\"" +
                     region.name + "\"> where that is meant");
    }
    look_at_facets();
  }

  void look_at_facets() {
    for (const auto& domain : options_.domains) {
      if (domain.kind != Domain::Kind::facets) continue;
      for (const auto& name : domain.regions) {
        const Region* const region = mesh_.find(name);
        if (region == nullptr || region->shape != CellShape::line) continue;
        std::vector<LocalIndex> within;
        for (const auto edge : region->edges)
          if (sides_.count(edge) == 2) within.push_back(edge);
        // Where none is on the boundary, the module says so itself.
        if (!within.empty() && within.size() < region->edges.size())
          found_.error(std::to_string(within.size()) + " of the " +
                       counted(region->edges.size(), "edge") + " of '" + name +
                       "' are not on the boundary but inside the body: " + found_.pieces(within) +
                       "; a boundary module needs boundary edges alone");
      }
    }
  }

  void look_at_boundary() {
    if (options_.open_boundary) return;
    std::vector<char> named(mesh_.edges.ids.size(), 0);
    for (const auto& region : mesh_.regions)
      if (region.shape == CellShape::line)
        for (const auto edge : region.edges)
          named[at(edge)] = 1;
    std::vector<LocalIndex> open;
    for (LocalIndex e = 0; e < mesh_.edges.size(); ++e)
      if (sides_.on_boundary(e) && !named[at(e)]) open.push_back(e);
    if (!open.empty())
      found_.note(counted(open.size(), "edge") + " of the body's boundary " +
                  (open.size() == 1 ? "is" : "are") + " in no region: " + found_.pieces(open) +
                  "; nothing is prescribed there and no traction acts. Name them in gmsh (Physical "
                  "Curve), or say <mesh open-boundary=\"true\"> where that is meant");
  }

  void look_at_modules() {
    if (options_.domains.empty()) return;
    std::vector<char> covered(mesh_.body.cell_ids.size(), 0);
    for (const auto& domain : options_.domains)
      for (const auto& name : domain.regions)
        if (const Region* const region = mesh_.find(name);
            region != nullptr && region->dimension == mesh_.dimension)
          for (const auto id : region->cell_ids)
            covered[static_cast<std::size_t>(id)] = 1;
    std::vector<LocalIndex> left;
    std::vector<std::string> names;
    for (LocalIndex c = 0; c < mesh_.body.size(); ++c)
      if (!covered[at(c)]) left.push_back(c);
    for (const auto& region : mesh_.regions)
      if (region.dimension == mesh_.dimension && !is_apart(region.name) &&
          std::any_of(region.cell_ids.begin(), region.cell_ids.end(),
                      [&](GlobalIndex id) { return !covered[static_cast<std::size_t>(id)]; }))
        names.push_back(region.name);
    if (!names.empty())
      found_.note(counted(left.size(), "cell") + " of the body's " +
                  std::to_string(mesh_.body.cell_ids.size()) + ", of " + in_quotes(names) +
                  ", belong to no module, " + found_.places_of_cells(left) +
                  "; nothing is computed there, and what is solved beside them ends there as at a "
                  "boundary without traction");
  }

  void look_at_parts() {
    const BodyParts parts = find_parts(mesh_, sides_);
    if (parts.count < 2) return;
    std::vector<std::vector<LocalIndex>> cells(at(parts.count));
    for (LocalIndex c = 0; c < mesh_.body.size(); ++c)
      cells[at(parts.of_cell[at(c)])].push_back(c);
    std::vector<char> meant(mesh_.body.cell_ids.size(), 0);
    for (const auto& name : options_.apart)
      if (const Region& region = mesh_.region(name); region.dimension == mesh_.dimension)
        for (const auto id : region.cell_ids)
          meant[static_cast<std::size_t>(id)] = 1;
    constexpr std::size_t most = 5;
    std::string text;
    std::size_t told = 0;
    for (const auto& part : cells) {
      if (std::all_of(part.begin(), part.end(), [&](LocalIndex c) { return meant[at(c)] != 0; }))
        continue;
      if (++told <= most)
        text += (text.empty() ? "" : ", ") + counted(part.size(), "cell") + " from " +
                position_text(mesh_, mesh_.body.vertices[at(3 * part.front())]);
    }
    if (told > 1)
      found_.note(
          "the body is in " + std::to_string(parts.count) + " parts that share no edge: " + text +
          (told > most ? " and others" : "") +
          "; nothing flows from one to the other. Where that is meant, name the region of each in "
          "<mesh apart=\"...\">");
    const auto inside = vertices_inside_other_parts(mesh_, parts);
    if (!inside.empty())
      found_.error("parts of the body lie over each other: " + counted(inside.size(), "node") +
                   " of one " + (inside.size() == 1 ? "is" : "are") + " inside cells of another, " +
                   found_.places(inside) + " in " + found_.regions_at(inside) +
                   "; cut the surfaces into each other in gmsh (BooleanFragments)");
  }

  void look_at_quality() {
    constexpr double poor = 1e-3;  // gmsh leaves nothing below 0.1
    std::vector<LocalIndex> cells;
    double least = poor;
    for (LocalIndex c = 0; c < mesh_.body.size(); ++c) {
      const double* corner[3];
      for (int k = 0; k < 3; ++k)
        corner[k] = &mesh_.coordinates[at(2 * mesh_.body.vertices[at(3 * c + k)])];
      const double quality = triangle_quality(corner[0], corner[1], corner[2]);
      if (quality < poor) cells.push_back(c);
      least = std::min(least, quality);
    }
    if (cells.empty()) return;
    std::ostringstream text;
    text << counted(cells.size(), "cell") << (cells.size() == 1 ? " is" : " are")
         << " nearly flat, of quality " << least << " at the least (1 is equilateral), "
         << found_.places_of_cells(cells);
    found_.note(text.str() + "; look at the mesh there, in gmsh Mesh.Optimize may help");
  }

  double coordinate(LocalIndex vertex, int j) const {
    return mesh_.coordinates[at(mesh_.dimension * vertex + j)];
  }

  const Mesh& mesh_;
  const MeshOptions& options_;
  Findings found_;
  const EdgeSides sides_;
  std::vector<char> apart_, on_body_;                          // vertices
  double shortest_ = std::numeric_limits<double>::infinity();  // edge of more than no length, m
};

}  // namespace

std::vector<MeshFinding> audit(const Mesh& mesh, const MeshOptions& options) {
  return Audit(mesh, options).findings();
}

}  // namespace hawser
