#pragma once
// What a replay leaves in its folder, and what an earlier one left there.
#include <map>
#include <optional>

#include "hawser/replay/fit.hpp"
#include "replay_model.hpp"

namespace hawser::program {

struct ReplayResults {
  const MeasuredLine& line;
  const std::vector<ReplayParameter>& parameters;  ///< with the values of the run
  Comparison model{}, path{};
  Positions positions{}, path_positions{};
  std::vector<ReplayParameter> fitted{};
  std::optional<FitResult> fit{};
  std::vector<std::string> told{};  ///< what the line does not tell
  double cpu_seconds = 0;           ///< of the last run
  int steps = 0;
};

/// Of a parameter whose value is in its own unit.
double si_value(const ReplayParameter& parameter);

/// A file, all of it. OutputError.
void write_text(const std::string& path, const std::string& text);
/// replay.json, residuals.csv, shots.csv. OutputError.
void write_results(const std::string& folder, const ReplayResults& results);
/// What a person is told at the end.
std::string told_results(const ReplayResults& results);

/// The parameters that an earlier replay ended with, SI. OutputError.
std::map<std::string, double> earlier_parameters(const std::string& folder);

}  // namespace hawser::program
