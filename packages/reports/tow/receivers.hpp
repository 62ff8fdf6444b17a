#pragma once
// Where each receiver of a towed cable is, at the times that a survey asks for: receivers.csv.
//
//   offset         m from the tow axis through the tow point, positive to starboard
//   feather_angle  degrees from straight astern to the line tow point - receiver, positive to
//                  starboard; for a receiver at the tow point that of the first segment
//   tension        N per metre of depth in two dimensions
//
// What is written does not change the run: between two steps everything is interpolated linearly.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hawser/navigation/navigation_line.hpp"
#include "hawser/report/line_geometry.hpp"
#include "hawser/report/report.hpp"
#include "tow_deck.hpp"

namespace hawser {

class Receivers {
 public:
  /// `axis`: the tow axis at a state, a unit vector of the mesh's dimension. Receivers beyond the
  /// cable's end go to `diagnostics`.
  Receivers(const Assembler& assembler, const LineGeometry& line, const ReceiversDeck& deck,
            std::function<std::vector<double>(const State&)> axis, Diagnostics& diagnostics);

  /// Times that the run does not come to.
  void look_ahead(const RunSpan& span, Diagnostics& diagnostics) const;

  /// Collective, as is stepped().
  void open(const std::string& file, const ReportStart& start);
  void stepped(const Step& step);
  /// m that the tow point has gone, which a restarted run goes on from.
  double way() const { return before_.way; }
  void resume(double way) { before_.way = way; }

 private:
  struct Sample {
    double time = 0, way = 0;  // s; m of the tow point
    Place head{};              // m, of the tow point
    std::vector<double> rows;  // [receiver][column]
  };
  Sample sample(const State& state) const;
  void append_between(const Sample& now, double share, double time);
  void append_shots(const Sample& now);

  const Assembler& assembler_;
  const LineGeometry& line_;
  ReceiversDeck deck_;
  std::function<std::vector<double>(const State&)> axis_;
  std::vector<double> places_;  // m, unstretched arc length of each receiver
  std::unique_ptr<History> file_;
  std::string folder_, name_;  // of receivers.csv
  Sample before_;
};

}  // namespace hawser
