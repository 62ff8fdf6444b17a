#include "hawser/fields/dof_map.hpp"

#include <algorithm>
#include <utility>

#include "hawser/base/error.hpp"
#include "src/ghost_exchange.hpp"

namespace hawser {
namespace {

constexpr LocalIndex absent = -1;
constexpr LocalIndex present = 0;  // until the point is numbered
constexpr PointKind all_kinds[] = {PointKind::vertex, PointKind::split_vertex, PointKind::edge};

std::size_t slot(PointKind kind) { return static_cast<std::size_t>(kind); }

bool by_sides(const FieldDescription& field) { return field.numbering == Numbering::sides; }

/// Calls visit(kind, point) for the nodes of one cell, in the order of the shape functions.
template <class Visit>
void visit_nodes(const FieldDescription& field, const Region& region, LocalIndex cell,
                 Visit&& visit) {
  const auto per_cell = static_cast<std::size_t>(region.vertices_per_cell);
  const auto c = static_cast<std::size_t>(cell);
  const bool split = by_sides(field) && !region.split_vertices.empty();
  for (std::size_t k = 0; k < per_cell; ++k)
    if (split)
      visit(PointKind::split_vertex, region.split_vertices[c * per_cell + k]);
    else
      visit(PointKind::vertex, region.vertices[c * per_cell + k]);
  if (node_layout(region.shape, field.basis).per_edge == 0) return;
  const auto edges = static_cast<std::size_t>(region.edges_per_cell);
  for (std::size_t k = 0; k < edges; ++k)
    visit(PointKind::edge, region.edges[c * edges + k]);
}

}  // namespace

DofMap::DofMap(const Mesh& mesh, std::vector<FieldDescription> fields)
    : mesh_(&mesh), fields_(std::move(fields)) {
  check_nodes();
  mark_presence();
  number_points(true);
  owned_ = rows();
  number_points(false);
  number_globally();
}

const PointSet& DofMap::points(PointKind kind) const {
  switch (kind) {
    case PointKind::vertex: return mesh_->vertices;
    case PointKind::split_vertex: return mesh_->split_vertices;
    default: return mesh_->edges;
  }
}

void DofMap::check_nodes() const {
  // Where there is a slit some vertex has two sides. All of the body's vertices are split ones.
  std::vector<char> seen(static_cast<std::size_t>(mesh_->vertices.size()), 0);
  bool slit = false;
  for (const LocalIndex vertex : mesh_->vertex_of_split)
    slit = slit || std::exchange(seen[static_cast<std::size_t>(vertex)], 1) != 0;
  slit = mesh_->communicator.any(slit);
  for (const FieldDescription& field : fields_) {
    if (slit && by_sides(field) && field.basis != Basis::p1)
      throw DeckError("the field '" + field.name +
                      "' is numbered by the sides of the slits, which " + to_string(field.basis) +
                      " fields cannot be yet: an edge has one node; <field name=\"" + field.name +
                      "\" basis=\"P1\"/> or numbering=\"continuous\" can");
    for (const Domain& domain : field.domains) {
      const CellShape shape = mesh_->region(domain).shape;
      const NodeLayout nodes = node_layout(shape, field.basis);
      if (nodes.per_face + nodes.inside > 0)
        throw DeckError("the field '" + field.name + "' has nodes within the " +
                        traits(shape).plural + " of region '" + domain.text() + "' with " +
                        to_string(field.basis) +
                        ", and nodes are numbered at vertices and on edges "
                        "only; P1 can be");
    }
  }
}

void DofMap::mark_presence() {
  for (const PointKind kind : all_kinds)
    first_row_[slot(kind)].assign(static_cast<std::size_t>(points(kind).size()) * fields_.size(),
                                  absent);
  for (std::size_t f = 0; f < fields_.size(); ++f)
    for (const Domain& domain : fields_[f].domains) {
      const Region& region = mesh_->region(domain);
      // A line has no sides: a split field lives where the surrounding cells put it.
      if (by_sides(fields_[f]) && region.split_vertices.empty() &&
          region.dimension < mesh_->dimension)
        continue;
      for (LocalIndex cell = 0; cell < region.size(); ++cell)
        visit_nodes(fields_[f], region, cell, [&](PointKind kind, LocalIndex point) {
          first_row_[slot(kind)][static_cast<std::size_t>(point) * fields_.size() + f] = present;
        });
    }
}

void DofMap::number_points(bool owned) {
  const auto number = [&](PointKind kind, LocalIndex point) {
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      LocalIndex& first =
          first_row_[slot(kind)][static_cast<std::size_t>(point) * fields_.size() + f];
      if (first == absent) continue;
      first = rows();
      for (int c = 0; c < fields_[f].components; ++c)
        info_.push_back({static_cast<int>(f), c, kind, point});
    }
  };
  const auto each = [&](PointKind kind, auto&& visit) {
    const LocalIndex begin = owned ? 0 : points(kind).owned;
    const LocalIndex end = owned ? points(kind).owned : points(kind).size();
    for (LocalIndex point = begin; point < end; ++point)
      visit(point);
  };
  // Edges first: an incomplete factorisation wants every pressure after the velocities around it.
  each(PointKind::edge, [&](LocalIndex point) { number(PointKind::edge, point); });

  std::vector<std::vector<LocalIndex>> splits(static_cast<std::size_t>(mesh_->vertices.size()));
  each(PointKind::split_vertex, [&](LocalIndex point) {
    splits[static_cast<std::size_t>(mesh_->vertex_of_split[static_cast<std::size_t>(point)])]
        .push_back(point);
  });
  each(PointKind::vertex, [&](LocalIndex point) {
    number(PointKind::vertex, point);
    for (const LocalIndex split : splits[static_cast<std::size_t>(point)])
      number(PointKind::split_vertex, split);
  });
}

void DofMap::number_globally() {
  const auto mine = static_cast<GlobalIndex>(owned_);
  GlobalIndex before = 0;
  MPI_Exscan(&mine, &before, 1, MPI_LONG_LONG, MPI_SUM, mesh_->communicator.mpi());
  if (mesh_->communicator.rank() == 0) before = 0;
  global_count_ = mesh_->communicator.sum(mine);
  global_rows_.resize(info_.size());
  for (LocalIndex row = 0; row < owned_; ++row)
    global_rows_[static_cast<std::size_t>(row)] = before + row;

  const std::size_t width = fields_.size();
  for (const PointKind kind : all_kinds) {
    const std::vector<LocalIndex>& first = first_row_[slot(kind)];
    std::vector<GlobalIndex> global(first.size(), absent);
    for (std::size_t i = 0; i < static_cast<std::size_t>(points(kind).owned) * width; ++i)
      if (first[i] != absent) global[i] = before + first[i];
    exchange_ghosts(mesh_->communicator, points(kind), width, global);
    for (std::size_t i = static_cast<std::size_t>(points(kind).owned) * width; i < first.size();
         ++i)
      if (first[i] != absent)
        for (int c = 0; c < fields_[i % width].components; ++c)
          global_rows_[static_cast<std::size_t>(first[i] + c)] = global[i] + c;
  }
}

int DofMap::find(const std::string& field) const {
  for (std::size_t f = 0; f < fields_.size(); ++f)
    if (fields_[f].name == field) return static_cast<int>(f);
  return -1;
}

LocalIndex DofMap::first_row(int field, PointKind kind, LocalIndex point) const {
  return first_row_[slot(kind)][static_cast<std::size_t>(point) * fields_.size() +
                                static_cast<std::size_t>(field)];
}

int DofMap::nodes_per_cell(int field, const Region& region) const {
  const NodeLayout nodes =
      node_layout(region.shape, fields_[static_cast<std::size_t>(field)].basis);
  return region.vertices_per_cell + nodes.per_edge * region.edges_per_cell;
}

void DofMap::append_cell_rows(int field, const Region& region, LocalIndex cell,
                              std::vector<LocalIndex>& first_rows) const {
  visit_nodes(fields_[static_cast<std::size_t>(field)], region, cell,
              [&](PointKind kind, LocalIndex point) {
                first_rows.push_back(first_row(field, kind, point));
              });
}

std::vector<LocalIndex> DofMap::region_rows(int field, const Region& region) const {
  std::vector<LocalIndex> result;
  if (by_sides(fields_[static_cast<std::size_t>(field)]) && region.split_vertices.empty()) {
    // A line or point has no sides: all that the field has at its vertices.
    std::vector<char> touched(static_cast<std::size_t>(mesh_->vertices.size()), 0);
    for (const LocalIndex vertex : region.vertices)
      touched[static_cast<std::size_t>(vertex)] = 1;
    for (LocalIndex split = 0; split < mesh_->split_vertices.size(); ++split)
      if (touched[static_cast<std::size_t>(
              mesh_->vertex_of_split[static_cast<std::size_t>(split)])] != 0)
        result.push_back(first_row(field, PointKind::split_vertex, split));
  } else {
    for (LocalIndex cell = 0; cell < region.size(); ++cell)
      append_cell_rows(field, region, cell, result);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  result.erase(std::remove(result.begin(), result.end(), absent), result.end());
  return result;
}

void DofMap::position(LocalIndex row, double* coordinates) const {
  const RowInfo& row_info = info(row);
  const auto point = static_cast<std::size_t>(row_info.point);
  const auto dimension = static_cast<std::size_t>(mesh_->dimension);
  const auto vertex = [&](LocalIndex v, std::size_t j) {
    return mesh_->coordinates[static_cast<std::size_t>(v) * dimension + j];
  };
  for (std::size_t j = 0; j < dimension; ++j)
    switch (row_info.kind) {
      case PointKind::vertex: coordinates[j] = vertex(row_info.point, j); break;
      case PointKind::split_vertex:
        coordinates[j] = vertex(mesh_->vertex_of_split[point], j);
        break;
      case PointKind::edge:
        coordinates[j] = 0.5 * (vertex(mesh_->edge_ends[2 * point], j) +
                                vertex(mesh_->edge_ends[2 * point + 1], j));
        break;
    }
}

GlobalIndex DofMap::point_id(LocalIndex row) const {
  return points(info(row).kind).ids[static_cast<std::size_t>(info(row).point)];
}

}  // namespace hawser
