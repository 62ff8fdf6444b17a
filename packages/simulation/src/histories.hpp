#pragma once
// CSV files that grow with the run: history.csv (quantities of the whole system), cable.csv (every
// node).
#include <memory>
#include <optional>
#include <string>

#include "hawser/output/history.hpp"
#include "src/force_report.hpp"
#include "src/tow_report.hpp"

namespace hawser {

/// A field at a point region's first vertex.
struct Probe {
  std::string name;
  std::string field;
  std::string unit;
  int components = 1;
  LocalIndex first_row = -1;  ///< owned here, or -1
};

/// Name of one component's column, without unit.
std::string probe_column(const Probe& probe, int component);

/// What one step amounts to, for the histories, the summary and the progress line.
struct StepFigures {
  int step = 0;
  double time = 0, length = 0;        ///< s, at the end of the step and its length
  std::optional<double> local_error;  ///< relative, of the time scheme; none in the first steps
  double balance_time = 0;            ///< s, at which pressures and forces stand
  int newton_iterations = 0, linear_iterations = 0;
  double mesh_quality = 1, courant = 0;
  TowMeasures tow;
  std::vector<Force> forces;
  std::vector<double> probes;
};

class Histories {
 public:
  Histories(const Mesh& mesh, const std::string& folder, const TowReport* tow,
            const std::vector<ForceReport>& forces, const std::vector<Probe>& probes,
            std::optional<double> keep_until);
  void append(const StepFigures& figures);
  void append_cable(const State& state);

 private:
  const TowReport* tow_;
  std::size_t dimension_;
  std::unique_ptr<History> system_, cable_;
};

}  // namespace hawser
