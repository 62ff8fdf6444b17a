#include "hawser/time/energy_ledger.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/physics/field_use.hpp"

namespace hawser {
namespace {

using Kind = EnergyTerm::Kind;

struct Part {
  const char* name;
  double EnergyAccount::*value;
};
constexpr Part parts[] = {{"first", &EnergyAccount::first},
                          {"supports", &EnergyAccount::supports},
                          {"boundaries", &EnergyAccount::boundaries},
                          {"time_dissipation", &EnergyAccount::time_dissipation},
                          {"residue", &EnergyAccount::residue},
                          {"done", &EnergyAccount::done}};

std::string numbered(const char* name, std::size_t i) { return name + std::to_string(i); }

}  // namespace

EnergyLedger::EnergyLedger(const Assembler& assembler)
    : assembler_(assembler),
      velocity_(assembler.dofs().find(field_name::velocity)),
      of_structure_(static_cast<std::size_t>(assembler.dofs().owned()), 0) {
  for (const auto& pair : assembler.kinematic_pairs())
    if (pair.velocity < assembler.dofs().owned())
      of_structure_[static_cast<std::size_t>(pair.velocity)] = 1;
}

void EnergyLedger::start(const State& initial) {
  account_ = {};
  account_.energy = assembler_.energies(initial);
  account_.work.assign(account_.energy.size(), 0);
  for (std::size_t i = 0; i < account_.energy.size(); ++i)
    if (stored(i)) account_.first += account_.energy[i];
}

EnergyAccount EnergyLedger::after_step(const CoupledProblem& problem) const {
  const State& state = problem.state();
  const double step = state.step;
  EnergyAccount next = account_;
  if (velocity_ < 0 || std::isinf(step)) return next;
  const Communicator& all = assembler_.dofs().mesh().communicator;

  double supports = 0, boundaries = 0;
  std::vector<char> counted(of_structure_.size(), 0);
  for (const PrescribedRow& prescribed : problem.prescribed()) {
    const auto row = static_cast<std::size_t>(prescribed.row);
    if (assembler_.dofs().info(prescribed.row).field != velocity_ || counted[row] != 0) continue;
    counted[row] = 1;
    (of_structure_[row] != 0 ? supports : boundaries) +=
        problem.reactions()[row] * state.value[row];
  }
  supports = step * all.sum(supports);
  boundaries = step * all.sum(boundaries);
  next.supports += supports;
  next.boundaries += boundaries;
  next.done += std::abs(supports) + std::abs(boundaries);

  const std::vector<double> powers = assembler_.powers(state);
  next.energy = assembler_.energies(problem.end());
  next.residue += supports + boundaries;
  for (std::size_t i = 0; i < powers.size(); ++i) {
    const double work = step * powers[i];
    const Kind kind = assembler_.energy_terms()[i].kind;
    next.residue -= work;
    next.work[i] += kind == Kind::supplied ? -work : work;
    if (kind == Kind::stored)
      next.time_dissipation += work - (next.energy[i] - account_.energy[i]);
    else if (kind == Kind::supplied)
      next.done += std::abs(work);
    else
      next.done += std::max(0.0, -work);  // drag drives what is slower than the water
  }
  return next;
}

bool EnergyLedger::grows(const EnergyAccount& next, double share) const {
  return next.time_dissipation < account_.time_dissipation &&
         -next.time_dissipation > share * (next.first + next.done);
}

CheckpointNotes EnergyLedger::save() const {
  CheckpointNotes notes;
  for (const Part& part : parts)
    notes.numbers[part.name] = account_.*part.value;
  for (std::size_t i = 0; i < account_.energy.size(); ++i) {
    notes.numbers[numbered("energy", i)] = account_.energy[i];
    notes.numbers[numbered("work", i)] = account_.work[i];
  }
  return notes;
}

void EnergyLedger::resume(const CheckpointNotes& notes) {
  account_ = {};
  for (const Part& part : parts)
    account_.*part.value = notes.numbers.at(part.name);
  for (std::size_t i = 0; i < assembler_.energy_terms().size(); ++i) {
    account_.energy.push_back(notes.numbers.at(numbered("energy", i)));
    account_.work.push_back(notes.numbers.at(numbered("work", i)));
  }
}

}  // namespace hawser
