#include "cut_mesh.hpp"

#include <algorithm>
#include <tuple>

#include "graph.hpp"
#include "whole_mesh.hpp"

namespace hawser {
namespace {

// The different numbers that occur, ascending.
std::vector<LocalIndex> distinct(std::vector<LocalIndex> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

// Sets the points of a part to the given numbers of the whole in their order, and returns the
// inverse.
template <class OwnerOf>
std::vector<LocalIndex> set_points(PointSet& points, const PointSet& whole, int rank,
                                   const std::vector<LocalIndex>& numbers, OwnerOf owner_of) {
  std::vector<LocalIndex> local_of(whole.ids.size(), -1);
  points.global_count = whole.global_count;
  for (const auto number : numbers) {
    local_of[at(number)] = points.size();
    points.ids.push_back(number);
    points.owners.push_back(owner_of(number));
    if (points.owners.back() == rank) ++points.owned;
  }
  return local_of;
}

void renumber(std::vector<LocalIndex>& numbers, const std::vector<LocalIndex>& local_of) {
  for (auto& number : numbers)
    number = local_of[at(number)];
}

}  // namespace

MeshCutter::MeshCutter(const Mesh& whole, const std::vector<int>& owner_of_vertex, int parts)
    : whole_(whole), owner_of_vertex_(owner_of_vertex) {
  const auto regions = all_regions(whole);
  cells_.resize(static_cast<std::size_t>(parts));
  for (auto& held : cells_)
    held.resize(regions.size());
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const auto& region = *regions[r];
    for (LocalIndex c = 0; c < region.size(); ++c) {
      for (int k = 0; k < region.vertices_per_cell; ++k) {
        const auto v = region.vertices[at(c * region.vertices_per_cell + k)];
        auto& cells = cells_[at(owner_of_vertex[at(v)])][r];
        if (cells.empty() || cells.back() != c) cells.push_back(c);
      }
    }
  }
}

// Still in the numbers of the whole mesh.
void MeshCutter::cut_regions(Mesh& part, int rank) const {
  part.regions.resize(whole_.regions.size());
  for (const auto& [domain, region] : whole_.derived)
    part.derived.emplace_back(domain, Region());
  const auto whole = all_regions(whole_);
  const auto parts = all_regions(part);
  for (std::size_t r = 0; r < whole.size(); ++r) {
    const auto& from = *whole[r];
    auto& to = *parts[r];
    to.name = from.name;
    to.dimension = from.dimension;
    to.shape = from.shape;
    to.vertices_per_cell = from.vertices_per_cell;
    to.edges_per_cell = from.edges_per_cell;
    for (const auto cell : cells_[at(rank)][r]) {
      const int n = from.vertices_per_cell;
      const auto* v = &from.vertices[at(cell * n)];
      to.cell_ids.push_back(from.cell_ids[at(cell)]);
      to.cell_owners.push_back(owner_of_vertex_[at(*std::min_element(v, v + n))]);
      append_cell(from.vertices, cell, n, to.vertices);
      if (!from.split_vertices.empty())
        append_cell(from.split_vertices, cell, n, to.split_vertices);
      append_cell(from.edges, cell, from.edges_per_cell, to.edges);
    }
  }
}

// Owned vertices by reverse Cuthill-McKee, then ghosts by owner and number.
std::vector<LocalIndex> MeshCutter::order_vertices(Mesh& part, int rank) const {
  std::vector<LocalIndex> known, edges, owned, order;
  for (const auto* region : all_regions(part)) {
    known.insert(known.end(), region->vertices.begin(), region->vertices.end());
    edges.insert(edges.end(), region->edges.begin(), region->edges.end());
  }
  known = distinct(std::move(known));
  std::vector<LocalIndex> place(owner_of_vertex_.size(), -1), ends;
  for (const auto v : known) {
    if (owner_of_vertex_[at(v)] != rank) continue;
    place[at(v)] = static_cast<LocalIndex>(owned.size());
    owned.push_back(v);
  }
  for (const auto e : distinct(std::move(edges))) {
    const auto a = place[at(whole_.edge_ends[at(2 * e)])];
    const auto b = place[at(whole_.edge_ends[at(2 * e + 1)])];
    if (a >= 0 && b >= 0) ends.insert(ends.end(), {a, b});
  }
  const auto graph = make_graph(static_cast<LocalIndex>(owned.size()), ends);
  for (const auto k : reverse_cuthill_mckee(graph))
    order.push_back(owned[at(k)]);
  for (const auto v : known) {
    if (place[at(v)] < 0) order.push_back(v);
  }
  const auto ghosts = order.begin() + static_cast<std::ptrdiff_t>(owned.size());
  std::stable_sort(ghosts, order.end(), [&](LocalIndex a, LocalIndex b) {
    return owner_of_vertex_[at(a)] < owner_of_vertex_[at(b)];
  });
  return order;
}

Mesh MeshCutter::part(int rank) const {
  Mesh part;
  part.communicator = whole_.communicator;
  part.dimension = whole_.dimension;
  if (rank == 0) part.notes = whole_.notes;
  cut_regions(part, rank);

  const auto owner = [&](LocalIndex v) { return owner_of_vertex_[at(v)]; };
  const auto vertices = order_vertices(part, rank);
  const auto local_vertex = set_points(part.vertices, whole_.vertices, rank, vertices, owner);
  for (const auto v : vertices) {
    for (int k = 0; k < part.dimension; ++k) {
      part.coordinates.push_back(whole_.coordinates[at(part.dimension * v + k)]);
    }
  }

  // Split vertices and edges in the order of the vertices that they belong to: the same good order.
  std::vector<LocalIndex> splits, edges;
  for (const auto* region : all_regions(part)) {
    splits.insert(splits.end(), region->split_vertices.begin(), region->split_vertices.end());
    edges.insert(edges.end(), region->edges.begin(), region->edges.end());
  }
  const auto vertex = [&](LocalIndex s) { return whole_.vertex_of_split[at(s)]; };
  const auto lower_end = [&](LocalIndex e) { return whole_.edge_ends[at(2 * e)]; };
  const auto order = [&](std::vector<LocalIndex>& numbers, auto vertex_of) {
    numbers = distinct(std::move(numbers));
    const auto key = [&](LocalIndex n) {
      const bool ghost = owner(vertex_of(n)) != rank;
      return std::tuple(ghost, ghost ? owner(vertex_of(n)) : local_vertex[at(vertex_of(n))], n);
    };
    std::sort(numbers.begin(), numbers.end(),
              [&](LocalIndex a, LocalIndex b) { return key(a) < key(b); });
  };
  order(splits, vertex);
  order(edges, lower_end);
  const auto local_split = set_points(part.split_vertices, whole_.split_vertices, rank, splits,
                                      [&](LocalIndex s) { return owner(vertex(s)); });
  const auto local_edge = set_points(part.edges, whole_.edges, rank, edges,
                                     [&](LocalIndex e) { return owner(lower_end(e)); });
  for (const auto s : splits)
    part.vertex_of_split.push_back(local_vertex[at(vertex(s))]);
  for (const auto e : edges) {
    part.edge_ends.push_back(local_vertex[at(whole_.edge_ends[at(2 * e)])]);
    part.edge_ends.push_back(local_vertex[at(whole_.edge_ends[at(2 * e + 1)])]);
  }
  for (auto* region : all_regions(part)) {
    renumber(region->vertices, local_vertex);
    renumber(region->split_vertices, local_split);
    renumber(region->edges, local_edge);
  }
  return part;
}

}  // namespace hawser
