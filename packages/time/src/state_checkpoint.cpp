#include "hawser/time/state_checkpoint.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "hawser/base/error.hpp"
#include "hawser/deck/value.hpp"
#include "src/memory_checkpoint.hpp"

namespace hawser {
namespace {

struct Part {
  const char* name;
  std::vector<double> TimeHistory::*values;
};
constexpr int part_count = 4;
const Part parts[part_count] = {{"value", &TimeHistory::value},
                                {"rate", &TimeHistory::rate},
                                {"quotient", &TimeHistory::quotient},
                                {"earlier-rate", &TimeHistory::earlier_rate}};

const char* kind_name(PointKind kind) {
  switch (kind) {
    case PointKind::vertex: return "vertices";
    case PointKind::split_vertex: return "split-vertices";
    default: return "edges";
  }
}

/// First rows of one field at points of one kind.
std::vector<LocalIndex> first_rows(const DofMap& dofs, int field, PointKind kind, LocalIndex end) {
  std::vector<LocalIndex> result;
  for (LocalIndex row = 0; row < end; ++row) {
    const RowInfo& info = dofs.info(row);
    if (info.field == field && info.component == 0 && info.kind == kind) result.push_back(row);
  }
  return result;
}

const PointSet& points(const Mesh& mesh, PointKind kind) {
  switch (kind) {
    case PointKind::vertex: return mesh.vertices;
    case PointKind::split_vertex: return mesh.split_vertices;
    default: return mesh.edges;
  }
}

/// Calls visit(array name, part, field, kind, first rows) for everything a checkpoint holds.
template <class Visit>
void visit_arrays(const DofMap& dofs, LocalIndex end, Visit&& visit) {
  for (int f = 0; f < static_cast<int>(dofs.fields().size()); ++f)
    for (const PointKind kind : {PointKind::vertex, PointKind::split_vertex, PointKind::edge}) {
      const std::vector<LocalIndex> rows = first_rows(dofs, f, kind, end);
      if (!dofs.mesh().communicator.any(!rows.empty())) continue;
      const std::string& field = dofs.fields()[static_cast<std::size_t>(f)].name;
      for (const Part& part : parts)
        visit(field + "-" + kind_name(kind) + "-" + part.name, part, f, kind, rows);
    }
}

/// A value per point of the mesh; 0 where the field does not live.
NamedArray whole_array(const DofMap& dofs, const std::vector<double>& values, int field,
                       PointKind kind) {
  const PointSet& all = points(dofs.mesh(), kind);
  NamedArray array{{},
                   dofs.fields()[static_cast<std::size_t>(field)].components,
                   all.global_count,
                   {all.ids.begin(), all.ids.begin() + all.owned},
                   {}};
  for (LocalIndex point = 0; point < all.owned; ++point) {
    const LocalIndex row = dofs.first_row(field, kind, point);
    for (LocalIndex c = 0; c < array.components; ++c)
      array.values.push_back(row < 0 ? 0 : values[static_cast<std::size_t>(row + c)]);
  }
  return array;
}

constexpr const char* positions_name = "vertices-position";

/// Where the mesh's vertices are at first: another run's state fits the same mesh alone.
NamedArray positions(const Mesh& mesh) {
  const PointSet& vertices = mesh.vertices;
  const auto numbers = static_cast<std::size_t>(vertices.owned * mesh.dimension);
  return {positions_name,
          mesh.dimension,
          vertices.global_count,
          {vertices.ids.begin(), vertices.ids.begin() + vertices.owned},
          {mesh.coordinates.begin(), mesh.coordinates.begin() + static_cast<long>(numbers)}};
}

/// Checkpoints of earlier versions do not know them.
void check_positions(const Mesh& mesh, const CheckpointReader& reader) {
  if (!reader.has(positions_name)) return;
  const NamedArray here = positions(mesh);
  if (reader.global_count(positions_name) != here.global_count)
    throw OutputError("it has another mesh, of " +
                      std::to_string(reader.global_count(positions_name)) + " vertices; here are " +
                      std::to_string(here.global_count));
  const std::vector<double> there = reader.read(positions_name, here.ids, here.components);
  double extent = 0, apart = 0;
  for (std::size_t i = 0; i < there.size(); ++i) {
    extent = std::max(extent, std::abs(here.values[i]));
    apart = std::max(apart, std::abs(there[i] - here.values[i]));
  }
  extent = mesh.communicator.max(extent);
  apart = mesh.communicator.max(apart);
  if (apart > 1e-9 * extent)
    throw OutputError("it has another mesh: vertices of one number lie up to " +
                      write_value(apart) + " m apart");
}

/// Of an array, what belongs to `rows`, which are first rows of a field with these components.
void read_rows(const DofMap& dofs, const CheckpointReader& reader, const std::string& name,
               const std::vector<LocalIndex>& rows, int components, std::vector<double>& result) {
  std::vector<GlobalIndex> ids;
  for (const LocalIndex row : rows)
    ids.push_back(dofs.point_id(row));
  const std::vector<double> values = reader.read(name, ids, components);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (int c = 0; c < components; ++c)
      result[static_cast<std::size_t>(rows[i] + c)] =
          values[i * static_cast<std::size_t>(components) + static_cast<std::size_t>(c)];
}

/// Of whose values the checkpoint has some.
std::set<std::string> names_of_fields(const CheckpointReader& reader) {
  std::set<std::string> result;
  for (const std::string& name : reader.names())
    // The first one counts: "-split-vertices" ends with "-vertices", too.
    for (const PointKind kind : {PointKind::split_vertex, PointKind::vertex, PointKind::edge}) {
      const std::string end = std::string("-") + kind_name(kind) + "-value";
      if (name.size() <= end.size() || name.compare(name.size() - end.size(), end.size(), end) != 0)
        continue;
      result.insert(name.substr(0, name.size() - end.size()));
      break;
    }
  return result;
}

}  // namespace

Checkpoint checkpoint_of(const DofMap& dofs, const TimeHistory& history,
                         const std::vector<CellMemory*>& memories, CheckpointHeader header) {
  std::vector<NamedArray> arrays;
  visit_arrays(dofs, dofs.owned(),
               [&](const std::string& name, const Part& part, int field, PointKind kind,
                   const std::vector<LocalIndex>& /*rows*/) {
                 arrays.push_back(whole_array(dofs, history.*part.values, field, kind));
                 arrays.back().name = name;
               });
  arrays.push_back(positions(dofs.mesh()));
  for (const CellMemory* const memory : memories)
    arrays.push_back(memory_array(dofs.mesh(), *memory));
  header.time = history.time;
  header.numbers["history_step_s"] = history.step;
  header.numbers["history_earlier_step_s"] = history.earlier_step;
  header.numbers["history_instant_s"] = history.instant;
  return {std::move(header), std::move(arrays)};
}

TimeHistory load_history(const DofMap& dofs, const CheckpointReader& reader) {
  TimeHistory history;
  history.time = reader.header().time;
  history.step = reader.header().numbers.at("history_step_s");
  history.earlier_step = reader.header().numbers.at("history_earlier_step_s");
  history.instant = reader.header().numbers.at("history_instant_s");
  for (const Part& part : parts)
    (history.*part.values).assign(static_cast<std::size_t>(dofs.rows()), 0);
  visit_arrays(dofs, dofs.rows(),
               [&](const std::string& name, const Part& part, int field, PointKind kind,
                   const std::vector<LocalIndex>& rows) {
                 const int components = dofs.fields()[static_cast<std::size_t>(field)].components;
                 if (!reader.has(name) ||
                     reader.global_count(name) != points(dofs.mesh(), kind).global_count)
                   throw OutputError("the checkpoint does not fit this mesh and these modules: '" +
                                     name + "' is missing or of another size");
                 read_rows(dofs, reader, name, rows, components, history.*part.values);
               });
  return history;
}

TakenFields take_fields(const DofMap& dofs, const CheckpointReader& reader, State& state) {
  check_positions(dofs.mesh(), reader);
  const auto& fields = dofs.fields();
  std::vector<int> wanted(fields.size(), 0), there(fields.size(), 0);  // arrays of values and rates
  const auto visit_state = [&](auto&& visit) {
    visit_arrays(dofs, dofs.rows(),
                 [&](const std::string& name, const Part& part, int field, PointKind kind,
                     const std::vector<LocalIndex>& rows) {
                   if (part.values == &TimeHistory::value)
                     visit(name, state.value, static_cast<std::size_t>(field), kind, rows);
                   if (part.values == &TimeHistory::rate)
                     visit(name, state.rate, static_cast<std::size_t>(field), kind, rows);
                 });
  };
  visit_state([&](const std::string& name, const std::vector<double>& /*values*/, std::size_t field,
                  PointKind kind, const std::vector<LocalIndex>& /*rows*/) {
    ++wanted[field];
    if (!reader.has(name)) return;
    ++there[field];
    if (reader.global_count(name) != points(dofs.mesh(), kind).global_count)
      throw OutputError("it has another mesh: " + std::to_string(reader.global_count(name)) + " " +
                        kind_name(kind) + ", here " +
                        std::to_string(points(dofs.mesh(), kind).global_count));
  });
  std::set<std::string> unused = names_of_fields(reader);
  TakenFields result;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const bool known = unused.erase(fields[f].name) > 0;
    if (known && there[f] < wanted[f])
      throw OutputError("field '" + fields[f].name + "' is in another basis or numbering there");
    (known ? result.taken : result.absent).push_back(fields[f].name);
  }
  result.unused.assign(unused.begin(), unused.end());
  visit_state([&](const std::string& name, std::vector<double>& values, std::size_t field,
                  PointKind /*kind*/, const std::vector<LocalIndex>& rows) {
    if (there[field] > 0) read_rows(dofs, reader, name, rows, fields[field].components, values);
  });
  return result;
}

}  // namespace hawser
