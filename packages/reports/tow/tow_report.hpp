#pragma once
// Positioning errors of a towed cable and the force at its tow point.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "hawser/report/force.hpp"
#include "hawser/report/line_geometry.hpp"
#include "hawser/report/report.hpp"
#include "receivers.hpp"
#include "tow_deck.hpp"

namespace hawser {

struct TowMeasures {
  double end_error = 0;        ///< m: distance of the tail from the tow axis
  double total_error = 0;      ///< m: mean over the cable's nodes (the paper's equation 8)
  double total_error_arc = 0;  ///< m: mean along the cable
  double cable_angle = 0;      ///< degrees, of the line tow point - tail from upstream
  double length = 0;           ///< m, of the stretched cable
};

/// Of a cable with its nodes at `positions` [node][dimension], in order from the tow point, seen
/// from the tow axis, a unit vector; `errors` are the nodes' distances from that axis.
TowMeasures measure_tow(const std::vector<double>& positions, const std::vector<double>& errors,
                        std::size_t dimension);

/// Distance of every node from the axis through the first one, m.
std::vector<double> distances_from_axis(const std::vector<double>& positions,
                                        const std::vector<double>& axis);

class TowReport : public Report {
 public:
  using Parameters = TowDeck;
  TowReport(const TowDeck& deck, const ReportContext& context, Diagnostics& diagnostics);

  std::vector<Column> columns() const override;
  std::vector<std::string> quantities() const override;
  void look_ahead(const Outlook& outlook, Diagnostics& diagnostics) const override;
  void start(const ReportStart& start) override;
  void write(const Step& step, bool fields_due) override;
  void save(CheckpointNotes& notes) const override;
  void resume(const CheckpointNotes& notes) override;
  void summarise(const Step& last, Summary& summary) const override;
  std::string closing() const override;
  const LineGeometry* line() const override { return line_.get(); }
  void add_fields(const Region& line, const State& state,
                  std::vector<PointField>& fields) const override;

 private:
  std::vector<double> measure(const Step& step) override;
  Force tow_force(const std::vector<double>& reactions, const std::vector<double>& axis) const;
  /// Unit vector in the plane z = 0 that points where the tow point goes. Collective.
  std::vector<double> axis(const State& state) const;
  /// The same where the deck says it for all times: without course="motion".
  std::vector<double> axis_as_said(double time) const;
  bool follows_motion() const { return deck_.course == TowDeck::Course::motion; }
  /// m/s of the tow point, in the plane z = 0. Collective.
  std::array<double, 2> motion(const State& state) const;
  /// Whether the deck says enough for one.
  bool has_exact() const { return deck_.current && (follows_motion() || track_ || deck_.speed); }
  /// End error of a cable that is straight along the relative flow, m; on a track, of its course
  /// and speed at that time. With has_exact(). Collective.
  double exact_end_error(double length, const State& state) const;
  void compare_motion(const Outlook& outlook, Diagnostics& diagnostics) const;

  const DofMap& dofs_;
  TowDeck deck_;
  LocalIndex tow_point_ = -1;           // where it is owned
  std::shared_ptr<const Track> track_;  // null: straight on, by the deck's angle and speed
  std::unique_ptr<LineGeometry> line_;
  std::unique_ptr<Receivers> receivers_;
  std::unique_ptr<History> nodes_;
  TowMeasures last_;
  std::optional<double> exact_;                        // m, the end error at the last step
  std::vector<std::pair<double, double>> end_errors_;  // time, error
};

}  // namespace hawser
