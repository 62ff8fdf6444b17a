#pragma once
// Positioning errors of a towed cable and the force at its tow point.
#include <vector>

#include "hawser/simulation/deck_parameters.hpp"
#include "src/force_report.hpp"
#include "src/line_geometry.hpp"

namespace hawser {

struct TowMeasures {
  double end_error = 0;        ///< m: distance of the tail from the tow axis
  double total_error = 0;      ///< m: mean over the cable's nodes (the paper's equation 8)
  double total_error_arc = 0;  ///< m: mean along the cable
  Force force;                 ///< what pulls at the tow point, seen from the tow axis
  double cable_angle = 0;      ///< degrees, of the line tow point - tail from upstream
  double length = 0;           ///< m, of the stretched cable
};

class TowReport {
 public:
  /// Faults (unknown regions) go to `diagnostics`. Collective.
  TowReport(const DofMap& dofs, const TowDeck& deck, Diagnostics& diagnostics);

  /// `reactions` per owned row. Collective.
  TowMeasures measure(const State& state, const std::vector<double>& reactions) const;

  /// Values of a cable that is straight along the relative flow: end and total error, m.
  double exact_end_error(double length) const;

  const LineGeometry& line() const { return *line_; }
  /// Distance of every node from the tow axis, m.
  std::vector<double> positioning_errors(const std::vector<double>& positions) const;

 private:
  const DofMap& dofs_;
  TowDeck deck_;
  std::unique_ptr<LineGeometry> line_;
  std::vector<double> axis_;  // of the tow, unit, in the plane z = 0
};

}  // namespace hawser
