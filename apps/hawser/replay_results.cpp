#include "replay_results.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

#include "hawser/base/error.hpp"
#include "hawser/deck/number.hpp"

namespace hawser::program {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values)
    list.push_back(std::isfinite(value) ? Json(value) : Json());
  return list;
}

Json summary(const Comparison& found) {
  return {{"rms_m", found.rms},
          {"tail_rms_m", found.tail_rms},
          {"median_m", found.median},
          {"greatest_m", found.greatest},
          {"places", found.count}};
}

Json fit_summary(const ReplayResults& results) {
  const FitResult& fit = *results.fit;
  Json json = {{"converged", fit.converged}, {"independent_numbers", fit.independent}};
  for (std::size_t i = 0; i < results.fitted.size(); ++i) {
    json["parameters"].push_back({{"name", results.fitted[i].name},
                                  {"unit", results.fitted[i].unit},
                                  {"value", fit.values[i]},
                                  {"standard_error", numbers({fit.standard_errors[i]})[0]}});
    json["correlations"].push_back(numbers(fit.correlations[i]));
  }
  for (const FitIteration& iteration : fit.iterations)
    json["iterations"].push_back({{"rms_m", iteration.rms}, {"values", numbers(iteration.values)}});
  json["what_cannot_be_told"] = results.told;
  return json;
}

std::string cell(double value) { return std::isnan(value) ? "" : fmt::format("{:.3f}", value); }

}  // namespace

double si_value(const ReplayParameter& parameter) {
  double value = no_value;
  read_number(parameter.value.substr(0, parameter.value.find(' ')), value);
  return value;
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw OutputError("cannot write " + path);
}

void write_results(const std::string& folder, const ReplayResults& results) {
  const MeasuredLine& line = results.line;
  Json json = {{"file", line.file},
               {"format", line.format},
               {"shots", line.times.size()},
               {"receivers", line.receivers.size()},
               {"duration_s", line.times.back()},
               {"speed_m_per_s", line.speed},
               {"cable_length_m", line.length()},
               {"origin_m", {line.origin[0], line.origin[1]}},
               {"frame", line.frame},
               {"smooth_s", line.smooth},
               {"head_noise_m", line.head_noise},
               {"notes", line.notes}};
  json["model"] = summary(results.model);
  json["path_in_the_water"] = summary(results.path);
  for (const ReplayParameter& parameter : results.parameters)
    json["parameters"][parameter.name] = si_value(parameter);
  if (results.fit) json["fit"] = fit_summary(results);
  json["steps"] = results.steps;
  json["cpu_s"] = results.cpu_seconds;
  json["times_real_time"] = line.times.back() / results.cpu_seconds;
  json["rms_by_shot_m"] = numbers(results.model.rms_of_shot);
  json["tail_error_by_shot_m"] = numbers(results.model.tail_error);
  write_text(folder + "/replay.json",
             json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");

  std::string residuals =
      "shot,time_s,receiver,arc_length_m,x_m,y_m,model_x_m,model_y_m,path_x_m,path_y_m,error_m\n";
  std::string shots = "shot,time_s,rms_m,tail_error_m,path_rms_m,path_tail_error_m\n";
  for (std::size_t s = 0; s < line.times.size(); ++s) {
    shots += fmt::format("{},{:.3f},{},{},{},{}\n", line.shot_numbers[s], line.times[s],
                         cell(results.model.rms_of_shot[s]), cell(results.model.tail_error[s]),
                         cell(results.path.rms_of_shot[s]), cell(results.path.tail_error[s]));
    for (std::size_t r = 0; r < line.receivers.size(); ++r) {
      const Place &measured = line.places[s][r], &model = results.positions[s][r],
                  &path = results.path_positions[s][r];
      residuals +=
          fmt::format("{},{:.3f},{},{:.3f},{},{},{:.3f},{:.3f},{:.3f},{:.3f},{}\n",
                      line.shot_numbers[s], line.times[s], line.receivers[r], line.arc_lengths[r],
                      cell(measured[0]), cell(measured[1]), model[0], model[1], path[0], path[1],
                      cell(std::hypot(model[0] - measured[0], model[1] - measured[1])));
    }
  }
  write_text(folder + "/residuals.csv", residuals);
  write_text(folder + "/shots.csv", shots);
}

std::string told_results(const ReplayResults& results) {
  const auto row = [](const std::string& name, const Comparison& found) {
    return fmt::format("{:<30}{:>10.1f}{:>10.1f}{:>10.1f}{:>10.1f}\n", name, found.rms,
                       found.median, found.greatest, found.tail_rms);
  };
  std::string text = fmt::format("\n{:<30}{:>10}{:>10}{:>10}{:>10}\n", "off by, m", "rms", "median",
                                 "greatest", "tail rms");
  text += row("the path in the water", results.path) + row("this model", results.model);
  if (results.fit)
    for (std::size_t i = 0; i < results.fitted.size(); ++i) {
      text += fmt::format("{:<16} {:>11.5g} +- {:.2g} {}", results.fitted[i].name,
                          results.fit->values[i], results.fit->standard_errors[i],
                          results.fitted[i].unit == "1" ? "" : results.fitted[i].unit);
      for (std::size_t j = 0; j < i; ++j)
        text += fmt::format("{} {:.2f} with {}", j == 0 ? "; correlation" : ",",
                            results.fit->correlations[i][j], results.fitted[j].name);
      text += "\n";
    }
  for (const std::string& sentence : results.told)
    text += sentence + "\n";
  text +=
      fmt::format("{} steps in {:.2f} s of processor time: {:.0f} times real time\n", results.steps,
                  results.cpu_seconds, results.line.times.back() / results.cpu_seconds);
  return text;
}

std::map<std::string, double> earlier_parameters(const std::string& folder) {
  const std::string path = folder + "/replay.json";
  std::ifstream file(path);
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("parameters"))
    throw OutputError("cannot read " + path + ", the result of an earlier replay");
  std::map<std::string, double> values;
  for (const auto& [name, value] : json["parameters"].items())
    if (value.is_number()) values[name] = value;
  return values;
}

}  // namespace hawser::program
