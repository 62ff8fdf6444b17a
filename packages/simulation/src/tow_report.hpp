#pragma once
// Positioning errors of a towed cable and the force at its tow point.
#include <memory>
#include <vector>

#include "hawser/simulation/deck_parameters.hpp"
#include "hawser/values/tracks.hpp"
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
  /// Faults (unknown regions, track) go to `diagnostics`. Collective.
  TowReport(const DofMap& dofs, const TowDeck& deck, const Tracks& tracks,
            Diagnostics& diagnostics);

  /// `reactions` per owned row. Collective.
  TowMeasures measure(const State& state, const std::vector<double>& reactions) const;

  /// Of a cable that is straight along the relative flow, m; on a track, of its course and speed at
  /// that time.
  double exact_end_error(double length, double time) const;

  const LineGeometry& line() const { return *line_; }
  /// The tow axis: a unit vector in the plane z = 0 that points where the tow point goes.
  std::vector<double> axis(double time) const;
  /// Distance of every node from the tow axis through the tow point, m.
  std::vector<double> positioning_errors(const std::vector<double>& positions, double time) const;

 private:
  const DofMap& dofs_;
  TowDeck deck_;
  std::shared_ptr<const Track> track_;  // null: straight on, by the deck's angle and speed
  std::unique_ptr<LineGeometry> line_;
};

}  // namespace hawser
