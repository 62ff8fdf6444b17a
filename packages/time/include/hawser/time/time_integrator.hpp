#pragma once
// Rates, predictors and the kinematics of structures (doc/numerics.md, "Time").
//
// A step goes from t_n to t_{n+1}; its equations are formed at t_n + alpha_f dt, and the unknowns
// of Newton's method are the values there:
//   u_a  = u_n + alpha_f (u_{n+1} - u_n),        u'_a = u'_n + alpha_m (u'_{n+1} - u'_n),
//   u_{n+1} = u_n + dt ((1 - gamma) u'_n + gamma u'_{n+1})      for velocities and the like.
// Fields without a rate (pressure) live at that instant. Newmark is alpha_m = alpha_f = 1.
//   structures       Newmark: d_{n+1} = d_n + dt ((1 - b) v_n + b v_{n+1}) + dt^2 (1/2 - b) v'_n,
//                    b = beta/gamma. Generalised-alpha: a first-order unknown, d'_a = v_a.
//   moving geometry  w_a = q + (2 alpha_f - 1) s (q - q_n),  q = (d_{n+1} - d_n)/dt,
//                    s = dt/(dt + dt_n): second order at the instant with a memory of one step, so
//                    that a kink in d is forgotten after two. On a structure's nodes w is the
//                    velocity itself: no flow through the cable.
//   BDF2             alpha_m = alpha_f = 1, and all rates are that difference; structures: d' = v.
//                    L-stable: what is fast is gone after a few steps.
// The first step is one of implicit Euler unless the deck's initial rates are to be trusted: the
// accelerations after it are those of the equations, and the values stay of second order.
#include <optional>
#include <vector>

#include "hawser/assembly/assembler.hpp"
#include "hawser/assembly/constraints.hpp"
#include "hawser/fields/state.hpp"
#include "hawser/time/time_scheme.hpp"

namespace hawser {

/// All that a step needs of the past; part of a checkpoint.
struct TimeHistory {
  double time = 0;            ///< s, of the last accepted step
  double step = 0;            ///< s, its length; 0 at the start
  double earlier_step = 0;    ///< s, of the step before; 0 when there was none
  double instant = 0;         ///< s, at which the last step's equations were formed
  std::vector<double> value;  ///< per local row
  std::vector<double> rate;
  std::vector<double> quotient;      ///< (u_n - u_{n-1})/dt_n; at the start the rate
  std::vector<double> earlier_rate;  ///< of the step before, for the estimate of the local error
};

class TimeIntegrator {
 public:
  TimeIntegrator(const Assembler& assembler, const std::vector<RateRule>& rules,
                 const TimeScheme& scheme);

  /// From initial values and rates; a geometry's first rate is taken as its quotient.
  void start(const State& initial);
  void resume(TimeHistory history);

  /// Sets time, step, rate slopes and the predicted values and rates of `state`, which stands at
  /// the instant of the equations.
  void begin_step(double step, State& state);
  /// Rates from values, at the present step.
  void update_rates(State& state) const;
  /// Values and rates at the end of the step from those at the instant of the equations.
  void extrapolate(const State& state, State& end) const;
  /// Whether the equations stand at the end of the step.
  bool at_end() const { return present_.alpha_f == 1; }
  /// A prescribed unknown's values at the equations' instant and at the end of the step. What the
  /// first has over the straight line to the second counts in the value, and not in its rate.
  void set_bend(LocalIndex row, double at_instant, double at_end);
  /// Per local row, to be spread from the owned ones.
  std::vector<double>& bend() { return bend_; }
  void accept(const State& state);

  /// The step's error of the velocities and the like, relative to the field (its value and what its
  /// rate makes of it in a step); root mean squares on the structures' nodes and on the others, the
  /// larger of them. By comparison with an explicit second-order step (Gresho, Lee & Sani, Recent
  /// Advances in Numerical Methods in Fluids 1 (1980) 27-79). Nothing in the first two steps.
  /// Collective.
  std::optional<double> local_error(const State& state) const;

  const Kinematics& kinematics() const { return kinematics_; }
  const TimeHistory& history() const { return history_; }

 private:
  bool is_structure(std::size_t row) const { return partner_[row] >= 0; }
  double end_value(const State& state, std::size_t row) const;
  double end_rate(const State& state, std::size_t row) const;

  const Assembler& assembler_;
  TimeScheme scheme_;
  std::vector<RateRule> rule_;       // per local row
  std::vector<LocalIndex> partner_;  // per local row: the velocity row it follows, or -1
  std::vector<char> is_partner_;     // per local row: 1 for a velocity that a structure follows
  TimeHistory history_;
  Kinematics kinematics_;
  std::vector<double> bend_;        // per local row: of a prescribed motion, see set_bend
  std::vector<double> known_rate_;  // per local row: what the past adds to the rate of this step
  StepCoefficients present_;        // of the step being made
  double step_ = 0;
};

}  // namespace hawser
