#include "src/histories.hpp"

namespace hawser {

std::string probe_column(const Probe& probe, int component) {
  std::string name = probe.name + "_" + probe.field;
  if (probe.components > 1) name += std::string("_") + static_cast<char>('x' + component);
  return name;
}

Histories::Histories(const Mesh& mesh, const std::string& folder, const TowReport* tow,
                     const std::vector<ForceReport>& forces, const std::vector<Probe>& probes,
                     std::optional<double> keep_until)
    : tow_(tow), dimension_(static_cast<std::size_t>(mesh.dimension)) {
  const Communicator& communicator = mesh.communicator;
  const std::string newton = mesh.force_unit();
  std::vector<Column> columns = {{"t", "s"},
                                 {"t_balance", "s"},
                                 {"step", "s"},
                                 {"local_error", ""},
                                 {"newton_iterations", ""},
                                 {"linear_iterations", ""},
                                 {"mesh_quality_min", ""},
                                 {"courant_max", ""}};
  if (tow != nullptr)
    for (const Column& column : {Column{"end_error", "m"},
                                 {"total_error", "m"},
                                 {"total_error_arc", "m"},
                                 {"tow_force", newton},
                                 {"tow_force_along", newton},
                                 {"tow_force_across", newton},
                                 {"cable_angle", "deg"},
                                 {"cable_length", "m"}})
      columns.push_back(column);
  for (const ForceReport& force : forces)
    for (const char* part : {"_force", "_force_along", "_force_across"})
      columns.push_back({force.name() + part, newton});
  for (const Probe& probe : probes)
    for (int c = 0; c < probe.components; ++c)
      columns.push_back({probe_column(probe, c), probe.unit});
  system_ = std::make_unique<History>(communicator, folder + "/history.csv", columns, keep_until);
  if (tow == nullptr) return;
  std::vector<Column> nodes = {{"t", "s"}, {"arc_length", "m"}, {"x", "m"}, {"y", "m"}};
  if (mesh.dimension == 3) nodes.push_back({"z", "m"});
  nodes.push_back({"positioning_error", "m"});
  cable_ = std::make_unique<History>(communicator, folder + "/cable.csv", nodes, keep_until);
}

void Histories::append(const StepFigures& figures) {
  std::vector<double> row = {figures.time,
                             figures.balance_time,
                             figures.length,
                             figures.local_error.value_or(0),
                             static_cast<double>(figures.newton_iterations),
                             static_cast<double>(figures.linear_iterations),
                             figures.mesh_quality,
                             figures.courant};
  if (tow_ != nullptr)
    for (const double value :
         {figures.tow.end_error, figures.tow.total_error, figures.tow.total_error_arc,
          figures.tow.force.magnitude, figures.tow.force.along, figures.tow.force.across,
          figures.tow.cable_angle, figures.tow.length})
      row.push_back(value);
  for (const Force& force : figures.forces)
    for (const double value : {force.magnitude, force.along, force.across})
      row.push_back(value);
  row.insert(row.end(), figures.probes.begin(), figures.probes.end());
  system_->append(row);
}

void Histories::append_cable(const State& state) {
  if (tow_ == nullptr) return;
  const std::vector<double> x = tow_->line().positions(state);
  const std::vector<double> errors = tow_->positioning_errors(x, state.time);
  std::vector<double> rows;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    rows.insert(rows.end(), {state.time, tow_->line().arc_length()[i]});
    for (std::size_t j = 0; j < dimension_; ++j)
      rows.push_back(x[dimension_ * i + j]);
    rows.push_back(errors[i]);
  }
  cable_->append(rows);
}

}  // namespace hawser
