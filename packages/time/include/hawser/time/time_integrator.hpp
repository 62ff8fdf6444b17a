#pragma once
// Rates, predictors and the kinematics of structures (doc/numerics.md, "Time").
//
// Newmark: momentum, pressure and geometry live at t_{n+1}.
//   dynamic fields      u' = (u - u_n) / (gamma dt) - (1 - gamma)/gamma u'_n
//   structures          d  = d_n + dt ((1 - b) v_n + b v) + dt^2 (1/2 - b) v'_n,  b = beta/gamma
//   moving geometry     w  = (1 + s) q - s q_n,  q = (d - d_n)/dt,  s = dt/(dt + dt_n): second
//   order at
//                       t_{n+1} with a memory of one step, so that a kink in d is forgotten after
//                       two. On a structure's nodes w is the velocity itself: no flow through the
//                       cable.
#include <vector>

#include "hawser/assembly/assembler.hpp"
#include "hawser/assembly/constraints.hpp"
#include "hawser/fields/state.hpp"

namespace hawser {

struct TimeScheme {
  bool steady = false;
  double beta = 0.3025;
  double gamma = 0.6;
};

/// All that a step needs of the past; part of a checkpoint.
struct TimeHistory {
  double time = 0;            ///< s, of the last accepted step
  double step = 0;            ///< s, its length; 0 at the start
  std::vector<double> value;  ///< per local row
  std::vector<double> rate;
  std::vector<double> quotient;  ///< (d_n - d_{n-1})/dt_n of moving geometry; at the start its rate
};

class TimeIntegrator {
 public:
  TimeIntegrator(const Assembler& assembler, const std::vector<RateRule>& rules,
                 const TimeScheme& scheme);

  /// From initial values and rates; a geometry's first rate is taken as its quotient.
  void start(const State& initial);
  void resume(TimeHistory history);

  /// Sets time, step, rate slopes and the predicted values and rates of `state`.
  void begin_step(double step, State& state);
  /// Rates from values, at the present step.
  void update_rates(State& state) const;
  void accept(const State& state);

  const Kinematics& kinematics() const { return kinematics_; }
  const TimeHistory& history() const { return history_; }

 private:
  bool is_structure(std::size_t row) const { return partner_[row] >= 0; }

  const Assembler& assembler_;
  TimeScheme scheme_;
  std::vector<RateRule> rule_;       // per local row
  std::vector<LocalIndex> partner_;  // per local row: the velocity row it follows, or -1
  TimeHistory history_;
  Kinematics kinematics_;
  double step_ = 0;
};

}  // namespace hawser
