#pragma once
// The energy balance of a run: what is stored, what was done to it since the start, and what of it
// cannot be explained (doc/numerics.md, "Energy").
#include <vector>

#include "hawser/output/checkpoint.hpp"
#include "hawser/time/coupled_problem.hpp"

namespace hawser {

/// Since the start, J, in a plane body per metre of depth. Works are integrals of the power at the
/// instants of the equations.
struct EnergyAccount {
  std::vector<double> energy;   ///< per Assembler::energy_terms(): of stored terms, what is there
  std::vector<double> work;     ///< per term: by what is supplied, into all others
  double first = 0;             ///< all that was stored at the start
  double supports = 0;          ///< by what prescribes the motion of structures
  double boundaries = 0;        ///< by other prescribed velocities: walls, inflow
  double time_dissipation = 0;  ///< rate of stored energies over the steps, less their gain
  double residue = 0;           ///< of the balance of powers: not converged, or not declared
  double done = 0;              ///< work done by supports, boundaries and loads, without signs, and
                                ///< what other terms have given

  double residue_of_work_done() const { return done > 0 ? residue / done : 0; }
};

class EnergyLedger {
 public:
  /// `assembler` must outlive it.
  explicit EnergyLedger(const Assembler& assembler);

  /// The energies of the initial state. Collective.
  void start(const State& initial);
  /// What the account becomes with the step just solved. Collective.
  EnergyAccount after_step(const CoupledProblem& problem) const;
  void accept(EnergyAccount account) { account_ = std::move(account); }
  const EnergyAccount& account() const { return account_; }

  /// The step that leads to `next` gains energy that nothing has supplied, and all that has been
  /// gained so is more than a share of what was stored at first and of the work done.
  bool grows(const EnergyAccount& next, double share) const;

  CheckpointNotes save() const;
  void resume(const CheckpointNotes& notes);

 private:
  bool stored(std::size_t term) const {
    return assembler_.energy_terms()[term].kind == EnergyTerm::Kind::stored;
  }
  const Assembler& assembler_;
  int velocity_;                    // field, or -1
  std::vector<char> of_structure_;  // per owned row: a structure's velocity
  EnergyAccount account_;
};

}  // namespace hawser
