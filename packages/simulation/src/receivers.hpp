#pragma once
// Where each receiver of a towed cable is, at the times that a survey asks for: receivers.csv.
//
//   offset         m from the tow axis through the tow point, positive to starboard
//   feather_angle  degrees from straight astern to the line tow point - receiver, positive to
//                  starboard; for a receiver at the tow point that of the first segment
//   tension        N per metre of depth in two dimensions
//
// What is written does not change the run: between two steps everything is interpolated linearly.
#include <memory>
#include <string>
#include <vector>

#include "hawser/assembly/assembler.hpp"
#include "hawser/output/history.hpp"
#include "hawser/time/time_integrator.hpp"
#include "src/tow_report.hpp"

namespace hawser {

class Receivers {
 public:
  Receivers(const Assembler& assembler, const TowReport& tow, const ReceiversDeck& deck);

  /// `start`: where the run begins or, if it `goes_on`, continues the file. Collective, as is
  /// stepped().
  void open(const std::string& folder, const TimeHistory& start, bool goes_on);
  void stepped(const State& state, int step, bool last);

 private:
  struct Sample {
    double time = 0;
    std::vector<double> rows;  // [receiver][column]
  };
  Sample sample(const State& state) const;

  const Assembler& assembler_;
  const TowReport& tow_;
  ReceiversDeck deck_;
  std::vector<double> places_;  // m, unstretched arc length of each receiver
  std::unique_ptr<History> file_;
  Sample before_;
};

}  // namespace hawser
