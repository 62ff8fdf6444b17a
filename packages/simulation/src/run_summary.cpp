#include "src/run_summary.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hawser {
namespace {

void set_force(Summary& summary, const std::string& name, const Force& force, const Mesh& mesh) {
  const std::string unit = mesh.force_unit();
  summary.set(quantity_name({name + "_force", unit}), force.magnitude);
  summary.set(quantity_name({name + "_force_along", unit}), force.along);
  summary.set(quantity_name({name + "_force_across", unit}), force.across);
}

}  // namespace

void RunSummary::add(const StepFigures& figures) {
  ++steps_;
  newton_ += figures.newton_iterations;
  linear_ += figures.linear_iterations;
  least_quality_ = std::min(least_quality_, figures.mesh_quality);
  courant_ = std::max(courant_, figures.courant);
  last_ = figures;
  end_errors_.emplace_back(figures.time, figures.tow.end_error);
}

void RunSummary::save(CheckpointHeader& header) const {
  auto& numbers = header.numbers;
  numbers["steps"] = static_cast<double>(steps_);
  numbers["rejected"] = static_cast<double>(rejected_);
  numbers["newton"] = static_cast<double>(newton_);
  numbers["linear"] = static_cast<double>(linear_);
  numbers["least_quality"] = least_quality_;
  numbers["courant"] = courant_;
  std::string& text = header.texts["end_errors"];
  for (const auto& [time, error] : end_errors_)
    text += write_value(time) + " " + write_value(error) + "\n";
}

void RunSummary::resume(const CheckpointHeader& header) {
  const auto& numbers = header.numbers;
  steps_ = static_cast<long long>(numbers.at("steps"));
  rejected_ = static_cast<long long>(numbers.at("rejected"));
  newton_ = static_cast<long long>(numbers.at("newton"));
  linear_ = static_cast<long long>(numbers.at("linear"));
  least_quality_ = numbers.at("least_quality");
  courant_ = numbers.at("courant");
  std::istringstream text(header.texts.at("end_errors"));
  for (double time = 0, error = 0; text >> time >> error;)
    end_errors_.emplace_back(time, error);
}

Summary RunSummary::summary(const System& system, const RunDeck& deck) const {
  Summary result;
  result.set("title", deck.title);
  result.set("end_time_s", last_.time);
  if (system.tow) {
    const TowMeasures& tow = last_.tow;
    const double exact = system.tow->exact_end_error(tow.length, last_.time);
    double least = tow.end_error, greatest = tow.end_error;
    for (const auto& [time, error] : end_errors_)
      if (time >= 0.75 * last_.time) {
        least = std::min(least, error);
        greatest = std::max(greatest, error);
      }
    result.set("end_error_m", tow.end_error);
    result.set("end_error_exact_m", exact);
    result.set("total_error_m", tow.total_error);
    result.set("total_error_exact_m", exact / 2);
    result.set("total_error_arc_m", tow.total_error_arc);
    result.set("end_error_change_last_quarter_m", greatest - least);
    set_force(result, "tow", tow.force, system.mesh);
    result.set("cable_angle_deg", tow.cable_angle);
    result.set("cable_length_m", tow.length);
  }
  for (std::size_t i = 0; i < system.forces.size(); ++i)
    set_force(result, system.forces[i].name(), last_.forces[i], system.mesh);
  std::size_t value = 0;
  for (const Probe& probe : system.probes)
    for (int c = 0; c < probe.components; ++c)
      result.set(quantity_name({probe_column(probe, c), probe.unit}), last_.probes[value++]);
  for (const ErrorReport& error : system.errors) {
    const bool ends =
        system.table.rate_rules[static_cast<std::size_t>(error.field())] != RateRule::none;
    const ErrorNorms norms = error.measure(ends ? system.problem->end() : system.problem->state());
    result.set(error.name() + "_error_l2", norms.l2);
    result.set(error.name() + "_error_max", norms.max);
  }
  result.set("mesh_quality_min", least_quality_);
  result.set("courant_max", courant_);
  result.set("steps", steps_);
  result.set("steps_rejected", rejected_);
  result.set("newton_iterations", newton_);
  result.set("newton_iterations_mean",
             steps_ > 0 ? static_cast<double>(newton_) / static_cast<double>(steps_) : 0);
  result.set("linear_iterations", linear_);
  result.set("linear_iterations_mean",
             newton_ > 0 ? static_cast<double>(linear_) / static_cast<double>(newton_) : 0);
  result.set("unknowns", system.dofs->global_count());
  result.set("nodes", system.mesh.vertices.global_count);
  return result;
}

void check_expectations(const RunDeck& deck, Summary& summary) {
  if (deck.expectations.empty()) return;
  long long failed = 0;
  for (const ExpectDeck& expect : deck.expectations) {
    const std::optional<double> got = summary.number(expect.quantity.value);
    const bool holds = got && std::abs(*got - expect.value) <= expect.within;
    if (!holds) ++failed;
    Summary& entry = summary.object("expectations").object(expect.quantity.value);
    entry.set("holds", holds);
    entry.set("expected", expect.value);
    entry.set("within", expect.within);
    if (got)
      entry.set("got", *got);
    else
      entry.set("got", "never evaluated: the run reports no such quantity");
    entry.set("why", expect.why);
    entry.set("where", expect.quantity.location.text());
  }
  summary.set("expectations_failed", failed);
}

}  // namespace hawser
