#include "hawser/time/state_checkpoint.hpp"

#include "hawser/base/error.hpp"

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

}  // namespace

void save_history(const DofMap& dofs, const TimeHistory& history, CheckpointHeader header,
                  const std::string& path) {
  std::vector<NamedArray> arrays;
  visit_arrays(dofs, dofs.owned(),
               [&](const std::string& name, const Part& part, int field, PointKind kind,
                   const std::vector<LocalIndex>& /*rows*/) {
                 arrays.push_back(whole_array(dofs, history.*part.values, field, kind));
                 arrays.back().name = name;
               });
  header.time = history.time;
  header.numbers["history_step_s"] = history.step;
  header.numbers["history_earlier_step_s"] = history.earlier_step;
  write_checkpoint(dofs.mesh().communicator, path, header, arrays);
}

TimeHistory load_history(const DofMap& dofs, const CheckpointReader& reader) {
  TimeHistory history;
  history.time = reader.header().time;
  history.step = reader.header().numbers.at("history_step_s");
  history.earlier_step = reader.header().numbers.at("history_earlier_step_s");
  for (const Part& part : parts)
    (history.*part.values).assign(static_cast<std::size_t>(dofs.rows()), 0);
  visit_arrays(
      dofs, dofs.rows(),
      [&](const std::string& name, const Part& part, int field, PointKind kind,
          const std::vector<LocalIndex>& rows) {
        const int components = dofs.fields()[static_cast<std::size_t>(field)].components;
        if (!reader.has(name) ||
            reader.global_count(name) != points(dofs.mesh(), kind).global_count)
          throw OutputError("the checkpoint does not fit this mesh and these modules: '" + name +
                            "' is missing or of another size");
        std::vector<GlobalIndex> ids;
        for (const LocalIndex row : rows)
          ids.push_back(dofs.point_id(row));
        const std::vector<double> values = reader.read(name, ids, components);
        for (std::size_t i = 0; i < rows.size(); ++i)
          for (int c = 0; c < components; ++c)
            (history.*part.values)[static_cast<std::size_t>(rows[i] + c)] =
                values[i * static_cast<std::size_t>(components) + static_cast<std::size_t>(c)];
      });
  return history;
}

}  // namespace hawser
