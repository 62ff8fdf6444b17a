#include "hawser/report/step_report.hpp"

#include <algorithm>

namespace hawser {

std::vector<Column> StepReport::columns() const {
  return {{"t", "s"},
          {"t_balance", "s"},
          {"step", "s"},
          {"local_error", ""},
          {"newton_iterations", ""},
          {"linear_iterations", ""},
          {"mesh_quality_min", ""},
          {"courant_max", ""}};
}

std::vector<double> StepReport::measure(const Step& step) {
  mesh_ = inspect_mesh(dofs_, step.end);
  ++steps_;
  newton_ += step.newton_iterations;
  linear_ += step.linear_iterations;
  least_quality_ = std::min(least_quality_, mesh_.least_quality);
  courant_ = std::max(courant_, mesh_.courant);
  return {step.end.time,
          step.balance.time,
          step.length,
          step.local_error.value_or(0),
          static_cast<double>(step.newton_iterations),
          static_cast<double>(step.linear_iterations),
          mesh_.least_quality,
          mesh_.courant};
}

void StepReport::save(CheckpointNotes& notes) const {
  notes.numbers["steps"] = static_cast<double>(steps_);
  notes.numbers["rejected"] = static_cast<double>(rejected_);
  notes.numbers["newton"] = static_cast<double>(newton_);
  notes.numbers["linear"] = static_cast<double>(linear_);
  notes.numbers["least_quality"] = least_quality_;
  notes.numbers["courant"] = courant_;
}

void StepReport::resume(const CheckpointNotes& notes) {
  steps_ = static_cast<long long>(notes.numbers.at("steps"));
  rejected_ = static_cast<long long>(notes.numbers.at("rejected"));
  newton_ = static_cast<long long>(notes.numbers.at("newton"));
  linear_ = static_cast<long long>(notes.numbers.at("linear"));
  least_quality_ = notes.numbers.at("least_quality");
  courant_ = notes.numbers.at("courant");
}

std::vector<std::string> StepReport::quantities() const {
  return {"end_time_s",
          "mesh_quality_min",
          "courant_max",
          "steps",
          "steps_rejected",
          "newton_iterations",
          "newton_iterations_mean",
          "linear_iterations",
          "linear_iterations_mean",
          "unknowns",
          "nodes"};
}

void StepReport::summarise(const Step& last, Summary& summary) const {
  const auto mean = [](long long sum, long long count) {
    return count > 0 ? static_cast<double>(sum) / static_cast<double>(count) : 0;
  };
  summary.set("end_time_s", last.end.time);
  summary.set("mesh_quality_min", least_quality_);
  summary.set("courant_max", courant_);
  summary.set("steps", steps_);
  summary.set("steps_rejected", rejected_);
  summary.set("newton_iterations", newton_);
  summary.set("newton_iterations_mean", mean(newton_, steps_));
  summary.set("linear_iterations", linear_);
  summary.set("linear_iterations_mean", mean(linear_, newton_));
  summary.set("unknowns", dofs_.global_count());
  summary.set("nodes", dofs_.mesh().vertices.global_count);
}

}  // namespace hawser
