#include "hawser/fields/region_sampling.hpp"

#include <algorithm>

namespace hawser {
namespace {

std::vector<LocalIndex> rows_of(const DofMap& dofs, int field, const Region& region,
                                LocalIndex cell) {
  std::vector<LocalIndex> rows;
  dofs.append_cell_rows(field, region, cell, rows);
  return rows;
}

/// The points of a rule on a line, on one edge of a cell.
Quadrature on_edge(const Quadrature& line, CellShape shape, std::size_t edge) {
  const ShapeTraits& cell = traits(shape);
  const double* const from = cell.vertex[cell.edge[edge][0]];
  const double* const to = cell.vertex[cell.edge[edge][1]];
  Quadrature result{shape, line.points, line.weights, {}};
  for (const double s : line.locations)
    for (int k = 0; k < cell.dimension; ++k)
      result.locations.push_back(from[k] + s * (to[k] - from[k]));
  return result;
}

}  // namespace

RegionSampling::RegionSampling(const DofMap& dofs, const Region& region,
                               const FieldExpression& formula, int moving, const Points& points,
                               Diagnostics& diagnostics)
    : dofs_(dofs),
      region_(region),
      sides_(sides_of(dofs.mesh(), region)),
      formula_(dofs, formula, !sides_.empty(), diagnostics) {
  if (!formula_.complete() || !check_fields(diagnostics)) return;
  const int degree = formula_.quadrature_degree(dofs, moving);
  if (sides_.empty()) {
    samplers_.emplace_back(dofs, region, points(region.shape, degree), formula_.fields(), moving);
    return;
  }
  const Region& body = dofs.mesh().body;
  const Quadrature line = points(CellShape::line, degree);
  for (int edge = 0; edge < traits(body.shape).edges; ++edge)
    samplers_.emplace_back(dofs, body, on_edge(line, body.shape, static_cast<std::size_t>(edge)),
                           formula_.fields(), moving);
}

/// All cells at a vertex that a rank owns are there: it knows the body's cells beside the lines
/// that it counts, which have such a vertex.
std::vector<RegionSampling::Side> RegionSampling::sides_of(const Mesh& mesh, const Region& region) {
  if (region.dimension != 1 || !mesh.has_body() || mesh.dimension != 2) return {};
  struct Beside {
    Side side{-1, 0};
    int count = 0;
  };
  std::vector<Beside> of_edge(static_cast<std::size_t>(mesh.edges.size()));
  const auto per_cell = static_cast<std::size_t>(mesh.body.edges_per_cell);
  for (std::size_t i = 0; i < mesh.body.edges.size(); ++i) {
    Beside& beside = of_edge[static_cast<std::size_t>(mesh.body.edges[i])];
    beside.side = {static_cast<LocalIndex>(i / per_cell), i % per_cell};
    ++beside.count;
  }
  std::vector<Side> sides(static_cast<std::size_t>(region.size()), Side{-1, 0});
  bool on_boundary = true;
  for (std::size_t cell = 0; cell < sides.size(); ++cell) {
    if (region.cell_owners[cell] != mesh.communicator.rank()) continue;
    const Beside& beside = of_edge[static_cast<std::size_t>(region.edges[cell])];
    on_boundary = on_boundary && beside.count == 1;
    sides[cell] = beside.side;
  }
  if (mesh.communicator.any(!on_boundary)) return {};
  if (sides.empty()) sides.push_back({-1, 0});  // of another rank's cells: on the boundary, too
  return sides;
}

bool RegionSampling::lives_beside(int field) const {
  bool everywhere = true;
  for (const Side& side : sides_) {
    if (side.cell < 0) continue;
    const auto rows = rows_of(dofs_, field, dofs_.mesh().body, side.cell);
    everywhere = everywhere && std::find(rows.begin(), rows.end(), -1) == rows.end();
  }
  return !dofs_.mesh().communicator.any(!everywhere);
}

bool RegionSampling::check_fields(Diagnostics& diagnostics) {
  const std::string begin =
      "the formula '" + formula_.formula().text() + "' on region '" + region_.name + "': ";
  const auto refuse = [&](const std::string& why) {
    diagnostics.error(formula_.formula().location(), begin + why);
    return false;
  };
  const Mesh& mesh = dofs_.mesh();
  // What lives on the line alone, as a cable along a wall may, is not to be seen from the body.
  if (!sides_.empty() && !formula_.has_normal() && !formula_.has_derivatives() &&
      !std::all_of(formula_.fields().begin(), formula_.fields().end(),
                   [&](int field) { return lives_beside(field); }))
    sides_.clear();
  for (const int field : formula_.fields()) {
    const FieldDescription& of = dofs_.fields()[static_cast<std::size_t>(field)];
    const bool lives =
        sides_.empty() ? lives_throughout(dofs_, field, region_) : lives_beside(field);
    if (lives) continue;
    if (sides_.empty() && of.numbering == Numbering::sides && region_.dimension < mesh.dimension)
      return refuse("'" + of.name + "' may have two values on a line within the body");
    return refuse("'" + of.name + "' is not solved for " +
                  (sides_.empty() ? "all over it" : "in all cells beside it"));
  }
  if (formula_.has_derivatives() && sides_.empty() && region_.dimension < mesh.dimension)
    return refuse(mesh.has_body()
                      ? "a derivative has two values on a line within the body, and one on its "
                        "boundary"
                      : "there are derivatives by place in a body only");
  return true;
}

Vector<double, 3> RegionSampling::normal(const Side& side) const {
  const ShapeTraits& cell = traits(dofs_.mesh().body.shape);
  double way[3] = {};
  for (int k = 0; k < cell.dimension; ++k)
    way[k] = cell.vertex[cell.edge[side.edge][1]][k] - cell.vertex[cell.edge[side.edge][0]][k];
  const Vector<double, 3> along = samplers_[side.edge].moved(way);
  // The body is on the left of the edges of its cells.
  Vector<double, 3> result;
  result[0] = along[1];
  result[1] = -along[0];
  return result;
}

Quadrature lattice(CellShape shape, int parts) {
  const ShapeTraits& cell = traits(shape);
  Quadrature result;
  result.shape = shape;
  const int last[3] = {cell.dimension > 0 ? parts : 0, cell.dimension > 1 ? parts : 0,
                       cell.dimension > 2 ? parts : 0};
  for (int k = 0; k <= last[2]; ++k)
    for (int j = 0; j <= last[1]; ++j)
      for (int i = 0; i <= last[0]; ++i) {
        if (cell.simplex && i + j + k > parts) continue;
        const double place[] = {double(i) / parts, double(j) / parts, double(k) / parts};
        result.locations.insert(result.locations.end(), place, place + cell.dimension);
        ++result.points;
      }
  result.weights.assign(static_cast<std::size_t>(result.points), 0);
  return result;
}

}  // namespace hawser
