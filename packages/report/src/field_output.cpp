#include "hawser/report/field_output.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "hawser/physics/field_use.hpp"
#include "hawser/report/line_geometry.hpp"

namespace hawser {
namespace {

std::vector<GlobalIndex> owned_ids(const PointSet& points) {
  return {points.ids.begin(), points.ids.begin() + points.owned};
}

/// Every cell of the body; vertices are doubled along slits so that the pressure's jump is seen.
Grid flow_grid(const Mesh& mesh) {
  Grid grid;
  grid.name = "flow";
  grid.kind = CellKind::triangle;
  grid.dimension = mesh.dimension;
  grid.point_count = mesh.split_vertices.global_count;
  grid.point_ids = owned_ids(mesh.split_vertices);
  const Region& body = mesh.body;
  for (std::size_t cell = 0; cell < body.cell_ids.size(); ++cell) {
    if (body.cell_owners[cell] != mesh.communicator.rank()) continue;
    grid.cell_ids.push_back(body.cell_ids[cell]);
    for (std::size_t k = 0; k < 3; ++k)
      grid.cells.push_back(
          mesh.split_vertices.ids[static_cast<std::size_t>(body.split_vertices[3 * cell + k])]);
  }
  grid.cell_count = mesh.communicator.sum(static_cast<long long>(grid.cell_ids.size()));
  return grid;
}

/// In the order of the report that has one, else with the numbers of the mesh. `points`: owned
/// vertices, ascending.
Grid line_grid(const Mesh& mesh, const Region& line, const LineGeometry* order,
               const std::vector<LocalIndex>& points) {
  Grid grid;
  grid.name = line.name == "flow" ? "flow_line" : line.name;  // the body's files are called flow
  grid.kind = CellKind::line;
  grid.dimension = mesh.dimension;
  if (order != nullptr)
    for (const LineGeometry::OwnedNode& node : order->owned())
      grid.point_ids.push_back(static_cast<GlobalIndex>(node.place));
  else
    for (const LocalIndex vertex : points)
      grid.point_ids.push_back(mesh.vertices.ids[static_cast<std::size_t>(vertex)]);
  for (std::size_t cell = 0; cell < line.cell_ids.size(); ++cell) {
    if (line.cell_owners[cell] != mesh.communicator.rank()) continue;
    const auto segment =
        order == nullptr ? -1 : static_cast<GlobalIndex>(order->segment_of_cell()[cell]);
    grid.cell_ids.push_back(order == nullptr ? line.cell_ids[cell] : segment);
    for (std::size_t k = 0; k < 2; ++k)
      grid.cells.push_back(
          order == nullptr
              ? mesh.vertices.ids[static_cast<std::size_t>(line.vertices[2 * cell + k])]
              : segment + static_cast<GlobalIndex>(k));
  }
  grid.point_count = mesh.communicator.sum(static_cast<GlobalIndex>(grid.point_ids.size()));
  grid.cell_count = mesh.communicator.sum(static_cast<GlobalIndex>(grid.cell_ids.size()));
  return grid;
}

/// Mean of the neighbouring cells' values at every point.
std::vector<double> mean_of_cells(const Region& line, const std::vector<LocalIndex>& points,
                                  const std::vector<double>& values) {
  std::vector<double> sums(points.size(), 0), counts(points.size(), 0);
  for (std::size_t k = 0; k < line.vertices.size(); ++k) {
    const auto point = std::lower_bound(points.begin(), points.end(), line.vertices[k]);
    if (point == points.end() || *point != line.vertices[k]) continue;
    sums[static_cast<std::size_t>(point - points.begin())] += values[k / 2];
    counts[static_cast<std::size_t>(point - points.begin())] += 1;
  }
  for (std::size_t p = 0; p < sums.size(); ++p)
    sums[p] /= counts[p];
  return sums;
}

}  // namespace

FieldOutput::FieldOutput(const Assembler& assembler, const std::vector<PhysicsModule>& modules,
                         const std::vector<std::unique_ptr<Report>>& reports,
                         const std::string& folder, int keep_until)
    : assembler_(assembler), dofs_(assembler.dofs()), reports_(reports) {
  const Mesh& mesh = dofs_.mesh();
  if (mesh.has_body())
    flow_ = std::make_unique<FieldWriter>(mesh.communicator, folder, flow_grid(mesh), keep_until);
  std::set<std::string> names;
  for (const PhysicsModule& module : modules)
    for (const auto& kernel : module.kernels)
      if (const Domain& domain = kernel->domain(); domain.kind != Domain::Kind::facets)
        names.insert(domain.regions.begin(), domain.regions.end());
  for (const auto& report : reports)
    if (report->line() != nullptr) names.insert(report->line()->region().name);
  for (const Region& region : mesh.regions)
    if (region.shape == CellShape::line && names.count(region.name) > 0)
      add_line(region, folder, keep_until);
}

void FieldOutput::add_line(const Region& region, const std::string& folder, int keep_until) {
  const Mesh& mesh = dofs_.mesh();
  LineGrid line{&region, nullptr, {}, {}, {}};
  for (const auto& report : reports_)
    if (line.order == nullptr && report->line() != nullptr && &report->line()->region() == &region)
      line.order = report->line();
  for (const LocalIndex vertex :
       std::set<LocalIndex>(region.vertices.begin(), region.vertices.end()))
    if (vertex < mesh.vertices.owned) line.points.push_back(vertex);
  for (int f = 0; f < static_cast<int>(dofs_.fields().size()); ++f) {
    const bool here = std::any_of(line.points.begin(), line.points.end(), [&](LocalIndex vertex) {
      return dofs_.first_row(f, PointKind::vertex, vertex) >= 0;
    });
    const bool shown = dofs_.fields()[static_cast<std::size_t>(f)].name != field_name::displacement;
    if (mesh.communicator.any(here) && shown) line.fields.push_back(f);
  }
  line.writer = std::make_unique<FieldWriter>(
      mesh.communicator, folder, line_grid(mesh, region, line.order, line.points), keep_until);
  lines_.push_back(std::move(line));
}

void FieldOutput::write(int step, const State& state) {
  if (flow_) write_flow(step, state);
  for (const LineGrid& line : lines_)
    write_line(line, step, state);
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
  for (PointField& quantity : body_quantities(state))
    fields.push_back(std::move(quantity));
  flow_->write(step, state.time, coordinates, fields);
}

/// Of one name on several regions they are one field; where none has it, it is not a number.
std::vector<PointField> FieldOutput::body_quantities(const State& state) const {
  const Mesh& mesh = dofs_.mesh();
  std::vector<std::size_t> place(mesh.body.cell_ids.size(), 0);  // among the counted cells
  std::vector<char> counted(place.size(), 0);
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < place.size(); ++cell) {
    counted[cell] = mesh.body.cell_owners[cell] == mesh.communicator.rank() ? 1 : 0;
    place[cell] = count;
    count += counted[cell] != 0 ? 1 : 0;
  }
  std::vector<PointField> fields;
  for (const Region& region : mesh.regions) {
    if (region.dimension != mesh.dimension) continue;
    const std::vector<LocalIndex> in_body = places_in(mesh.body, region);
    for (const auto& quantity : assembler_.cell_quantities(region, state)) {
      const bool taken = dofs_.find(quantity.name) >= 0;
      const std::string name = quantity.name + (taken ? "_of_cells" : "");
      auto field = std::find_if(fields.begin(), fields.end(),
                                [&](const PointField& known) { return known.name == name; });
      if (field == fields.end()) {
        const std::vector<double> nothing(count, std::numeric_limits<double>::quiet_NaN());
        field = fields.insert(field, {name, quantity.unit, 1, nothing, true});
      }
      for (std::size_t i = 0; i < in_body.size(); ++i) {
        const auto cell = static_cast<std::size_t>(in_body[i]);
        if (counted[cell] != 0) field->values[place[cell]] = quantity.values[i];
      }
    }
  }
  return fields;
}

PointField FieldOutput::at_points(const LineGrid& line, int field, const State& state) const {
  const FieldDescription& description = dofs_.fields()[static_cast<std::size_t>(field)];
  PointField result{description.name, description.unit, description.components, {}};
  for (const LocalIndex vertex : line.points) {
    const LocalIndex first = dofs_.first_row(field, PointKind::vertex, vertex);
    for (LocalIndex c = 0; c < description.components; ++c)
      result.values.push_back(first < 0 ? 0 : state.value[static_cast<std::size_t>(first + c)]);
  }
  return result;
}

void FieldOutput::write_line(const LineGrid& line, int step, const State& state) {
  const Mesh& mesh = dofs_.mesh();
  const auto dimension = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> coordinates;
  for (const LocalIndex vertex : line.points)
    for (std::size_t j = 0; j < dimension; ++j)
      coordinates.push_back(mesh.coordinates[static_cast<std::size_t>(vertex) * dimension + j]);
  if (const int moved = dofs_.find(field_name::displacement); moved >= 0) {
    const std::vector<double> displacement = at_points(line, moved, state).values;
    for (std::size_t i = 0; i < coordinates.size(); ++i)
      coordinates[i] += displacement[i];
  }
  std::vector<PointField> fields;
  if (line.order != nullptr) {
    PointField& arc = fields.emplace_back(PointField{"arc_length", "m", 1, {}});
    for (const LineGeometry::OwnedNode& node : line.order->owned())
      arc.values.push_back(line.order->arc_length()[node.place]);
  }
  for (const auto& report : reports_)
    report->add_fields(*line.region, state, fields);
  for (const int field : line.fields)
    fields.push_back(at_points(line, field, state));
  for (const auto& quantity : assembler_.cell_quantities(*line.region, state))
    fields.push_back({quantity.name, quantity.unit, 1,
                      mean_of_cells(*line.region, line.points, quantity.values)});
  line.writer->write(step, state.time, coordinates, fields);
}

}  // namespace hawser
