#include "src/field_output.hpp"

#include <algorithm>

#include "hawser/physics/field_use.hpp"

namespace hawser {
namespace {

std::vector<GlobalIndex> owned_ids(const PointSet& points) {
  return {points.ids.begin(), points.ids.begin() + points.owned};
}

/// Every triangle of the mesh; vertices are doubled along slits so that the pressure's jump is
/// seen.
Grid flow_grid(const Mesh& mesh) {
  Grid grid;
  grid.name = "flow";
  grid.kind = CellKind::triangle;
  grid.dimension = mesh.dimension;
  grid.point_count = mesh.split_vertices.global_count;
  grid.point_ids = owned_ids(mesh.split_vertices);
  for (const Region& region : mesh.regions) {
    if (region.shape != CellShape::triangle) continue;
    for (std::size_t cell = 0; cell < region.cell_ids.size(); ++cell) {
      if (region.cell_owners[cell] != mesh.communicator.rank()) continue;
      grid.cell_ids.push_back(region.cell_ids[cell]);
      for (std::size_t k = 0; k < 3; ++k)
        grid.cells.push_back(
            mesh.split_vertices.ids[static_cast<std::size_t>(region.split_vertices[3 * cell + k])]);
    }
  }
  grid.cell_count = mesh.communicator.sum(static_cast<long long>(grid.cell_ids.size()));
  return grid;
}

Grid cable_grid(const Mesh& mesh, const LineGeometry& line) {
  Grid grid;
  grid.name = "cable";
  grid.kind = CellKind::line;
  grid.dimension = mesh.dimension;
  grid.point_count = static_cast<GlobalIndex>(line.size());
  grid.cell_count = grid.point_count - 1;
  for (const auto& node : line.owned()) {
    const auto place = static_cast<GlobalIndex>(node.place);
    grid.point_ids.push_back(place);
    if (place == grid.cell_count) continue;
    grid.cell_ids.push_back(place);
    grid.cells.push_back(place);
    grid.cells.push_back(place + 1);
  }
  return grid;
}

}  // namespace

FieldOutput::FieldOutput(const Assembler& assembler, const TowReport* tow,
                         const std::string& folder, int keep_until)
    : assembler_(assembler), dofs_(assembler.dofs()), tow_(tow) {
  const Mesh& mesh = dofs_.mesh();
  if (mesh.has_body())
    flow_ = std::make_unique<FieldWriter>(mesh.communicator, folder, flow_grid(mesh), keep_until);
  if (tow_ != nullptr)
    cable_ = std::make_unique<FieldWriter>(mesh.communicator, folder,
                                           cable_grid(mesh, tow_->line()), keep_until);
}

void FieldOutput::write(int step, const State& state) {
  if (flow_) write_flow(step, state);
  if (cable_) write_cable(step, state);
}

void FieldOutput::write_flow(int step, const State& state) {
  const Mesh& mesh = dofs_.mesh();
  const auto points = static_cast<std::size_t>(mesh.split_vertices.owned);
  const auto dimension = static_cast<std::size_t>(mesh.dimension);
  const auto row_of = [&](std::size_t field, std::size_t point) {
    return dofs_.fields()[field].numbering == Numbering::sides
               ? dofs_.first_row(static_cast<int>(field), PointKind::split_vertex,
                                 static_cast<LocalIndex>(point))
               : dofs_.first_row(static_cast<int>(field), PointKind::vertex,
                                 mesh.vertex_of_split[point]);
  };
  std::vector<double> coordinates(points * dimension);
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t j = 0; j < dimension; ++j)
      coordinates[p * dimension + j] =
          mesh.coordinates[static_cast<std::size_t>(mesh.vertex_of_split[p]) * dimension + j];
  std::vector<PointField> fields;
  for (std::size_t f = 0; f < dofs_.fields().size(); ++f) {
    const FieldDescription& description = dofs_.fields()[f];
    PointField field{description.name, description.unit, description.components, {}};
    const auto components = static_cast<std::size_t>(description.components);
    field.values.assign(points * components, 0);
    for (std::size_t p = 0; p < points; ++p) {
      const LocalIndex first = row_of(f, p);
      for (std::size_t c = 0; first >= 0 && c < components; ++c)
        field.values[p * components + c] = state.value[static_cast<std::size_t>(first) + c];
    }
    if (field.name == field_name::displacement)
      for (std::size_t i = 0; i < coordinates.size(); ++i)
        coordinates[i] += field.values[i];
    fields.push_back(std::move(field));
  }
  flow_->write(step, state.time, coordinates, fields);
}

void FieldOutput::write_cable(int step, const State& state) {
  const LineGeometry& line = tow_->line();
  const std::vector<double> x = line.positions(state);
  const std::vector<double> v = line.gather(field_name::velocity, state);
  const std::vector<double> errors = tow_->positioning_errors(x, state.time);
  std::vector<double> coordinates;
  PointField arc{"arc_length", "m", 1, {}}, error{"positioning_error", "m", 1, {}};
  const auto dimension = static_cast<std::size_t>(dofs_.mesh().dimension);
  PointField velocity{field_name::velocity, "m/s", dofs_.mesh().dimension, {}};
  for (const auto& node : line.owned()) {
    for (std::size_t j = 0; j < dimension; ++j) {
      coordinates.push_back(x[dimension * node.place + j]);
      velocity.values.push_back(v[dimension * node.place + j]);
    }
    arc.values.push_back(line.arc_length()[node.place]);
    error.values.push_back(errors[node.place]);
  }
  std::vector<PointField> fields = {arc, error, velocity};
  for (const auto& quantity : assembler_.cell_quantities(line.region(), state)) {
    const std::vector<double> segments = line.gather_cells(quantity.values);
    PointField field{quantity.name, quantity.unit, 1, {}};
    for (const auto& node : line.owned()) {  // mean of the neighbouring segments
      const std::size_t before = node.place == 0 ? 0 : node.place - 1;
      const std::size_t after = std::min(node.place, segments.size() - 1);
      field.values.push_back(0.5 * (segments[before] + segments[after]));
    }
    fields.push_back(std::move(field));
  }
  cable_->write(step, state.time, coordinates, fields);
}

}  // namespace hawser
