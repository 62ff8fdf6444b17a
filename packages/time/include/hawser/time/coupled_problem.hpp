#pragma once
// All modules, conditions and the time scheme as one nonlinear problem per step.
#include <memory>
#include <vector>

#include "hawser/algebra/nonlinear_problem.hpp"
#include "hawser/base/stopwatch.hpp"
#include "hawser/conditions/conditions.hpp"
#include "hawser/time/time_integrator.hpp"

namespace hawser {

class CoupledProblem : public NonlinearProblem {
 public:
  CoupledProblem(Assembler& assembler, TimeIntegrator& integrator, const Conditions& conditions);

  /// The state as it is now becomes the start.
  void start();
  /// Predicts the state and puts the prescribed values in.
  void begin_step(double step);
  /// The predicted state as the vector of unknowns, for Newton to start from.
  std::shared_ptr<TpetraVector> guess() const;
  /// Whether laws that switch are on the branches that Newton held; those that are not are
  /// themselves from now on, and x is to be solved for again.
  bool on_held_branches(const TpetraVector& x);
  /// All laws are themselves from now on; false when they were already.
  bool release_switches() { return assembler_.release_switches(); }
  /// Makes x the state and evaluates the balances there, so that reactions() belongs to it.
  void finish_step(const TpetraVector& x);
  /// The step becomes the past. What cells remember of it is read from the next step on.
  void accept() {
    assembler_.remember(state_);
    integrator_.accept(state_);
  }

  BlockSystem& system() override { return assembler_.system(); }
  void residual(const TpetraVector& x, TpetraVector& f, TpetraVector& magnitude) override;
  void jacobian(const TpetraVector& x) override;
  /// While the same rows are prescribed and the step is about as long.
  bool jacobian_lasts() const override;

  /// At the instant at which the step's equations are formed; balances, reactions and fields
  /// without a rate (pressure) live there.
  State& state() { return state_; }
  const State& state() const { return state_; }
  /// At the end of the step.
  const State& end() const { return end_; }
  /// Per owned row, what supports must supply: the assembled balance before any condition.
  const std::vector<double>& reactions() const { return total_; }

  /// What is prescribed in this step, owned rows.
  const std::vector<PrescribedRow>& prescribed() const { return constraints_.prescribed(); }

  double residual_seconds() const { return residual_watch_.seconds(); }
  double tangent_seconds() const { return tangent_watch_.seconds(); }

 private:
  void set_state(const TpetraVector& x);
  void prescribe();
  void level_with_prescribed();

  Assembler& assembler_;
  TimeIntegrator& integrator_;
  const Conditions& conditions_;
  Constraints constraints_;
  State state_, end_;
  double jacobian_step_ = 0;                ///< s, of the last Jacobian
  std::vector<LocalIndex> jacobian_fixed_;  ///< rows that were prescribed in it
  std::vector<double> total_, residual_, magnitude_;
  std::vector<double> evaluated_;  ///< owned unknowns at which total_ was assembled
  Stopwatch residual_watch_, tangent_watch_;
};

}  // namespace hawser
