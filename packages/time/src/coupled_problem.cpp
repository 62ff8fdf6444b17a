#include "hawser/time/coupled_problem.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>

namespace hawser {

CoupledProblem::CoupledProblem(Assembler& assembler, TimeIntegrator& integrator,
                               const Conditions& conditions)
    : assembler_(assembler),
      integrator_(integrator),
      conditions_(conditions),
      constraints_(assembler) {
  const auto rows = static_cast<std::size_t>(assembler.dofs().rows());
  for (auto* array :
       {&state_.value, &state_.rate, &state_.accepted, &state_.rate_slope, &state_.rate_partner})
    array->assign(rows, 0);
}

void CoupledProblem::start() {
  integrator_.start(state_);
  end_ = state_;
}

void CoupledProblem::begin_step(double step) {
  evaluated_.clear();
  assembler_.begin_step();
  integrator_.begin_step(step, state_);
  assembler_.hold_switches();
  prescribe();
  level_with_prescribed();
  for (const PrescribedRow& row : constraints_.prescribed())
    state_.value[static_cast<std::size_t>(row.row)] = row.value;
  assembler_.spread(state_.value);
  integrator_.update_rates(state_);
  integrator_.extrapolate(state_, end_);
}

// A field of which only differences count, a pressure, follows its prescribed values as a whole.
void CoupledProblem::level_with_prescribed() {
  const DofMap& dofs = assembler_.dofs();
  for (std::size_t field = 0; field < dofs.fields().size(); ++field) {
    if (!dofs.fields()[field].has_level) continue;
    const auto in_field = [&](LocalIndex row) {
      return static_cast<std::size_t>(dofs.info(row).field) == field;
    };
    double rise = 0, count = 0;
    for (const PrescribedRow& row : constraints_.prescribed()) {
      if (!in_field(row.row)) continue;
      rise += row.value - state_.value[static_cast<std::size_t>(row.row)];
      count += 1;
    }
    count = dofs.mesh().communicator.sum(count);
    if (count == 0) continue;
    rise = dofs.mesh().communicator.sum(rise) / count;
    for (LocalIndex row = 0; row < dofs.owned(); ++row)
      if (in_field(row)) state_.value[static_cast<std::size_t>(row)] += rise;
  }
}

void CoupledProblem::prescribe() {
  integrator_.extrapolate(state_, end_);
  std::vector<PrescribedRow> rows = conditions_.prescribed(state_, end_);
  if (!integrator_.at_end()) {
    // Values at the equations' own instant: averages over the step would carry a net flow through
    // a closed boundary that deforms (doc/decisions/0052-prescribed-at-the-instant.md).
    std::vector<PrescribedRow> now = conditions_.prescribed(state_, state_);
    for (std::size_t i = 0; i < now.size(); ++i)
      integrator_.set_bend(now[i].row, now[i].value, rows[i].value);
    assembler_.spread(integrator_.bend());
    rows = std::move(now);
  }
  constraints_.prescribe(std::move(rows));
}

std::shared_ptr<TpetraVector> CoupledProblem::guess() const {
  auto x = std::make_shared<TpetraVector>(assembler_.system().rows);
  const auto view = x->getDataNonConst();
  std::copy(state_.value.begin(), state_.value.begin() + view.size(), view.begin());
  return x;
}

void CoupledProblem::set_state(const TpetraVector& x) {
  assembler_.spread(x, state_.value);
  integrator_.update_rates(state_);
  if (conditions_.follow_the_mesh()) prescribe();
}

bool CoupledProblem::on_held_branches(const TpetraVector& x) {
  set_state(x);
  return !assembler_.release_wrong_switches(state_);
}

void CoupledProblem::finish_step(const TpetraVector& x) {
  const auto lap = residual_watch_.lap();
  set_state(x);
  integrator_.extrapolate(state_, end_);
  // Newton's last evaluation was, as a rule, at its solution.
  const auto view = x.getData();
  const bool same = std::equal(view.begin(), view.end(), evaluated_.begin(), evaluated_.end());
  if (assembler_.dofs().mesh().communicator.sum(same ? 0LL : 1LL) > 0)
    assembler_.residual(state_, total_);
}

void CoupledProblem::residual(const TpetraVector& x, TpetraVector& f, TpetraVector& magnitude) {
  const auto lap = residual_watch_.lap();
  set_state(x);
  assembler_.residual(state_, total_, magnitude_);
  const auto view = x.getData();
  evaluated_.assign(view.begin(), view.end());
  residual_ = total_;
  constraints_.apply(state_, integrator_.kinematics(), residual_, magnitude_);
  const auto f_view = f.getDataNonConst();
  const auto magnitude_view = magnitude.getDataNonConst();
  std::copy(residual_.begin(), residual_.end(), f_view.begin());
  std::copy(magnitude_.begin(), magnitude_.end(), magnitude_view.begin());
}

void CoupledProblem::jacobian(const TpetraVector& x) {
  const auto lap = tangent_watch_.lap();
  set_state(x);
  assembler_.tangent(state_);
  constraints_.apply(integrator_.kinematics());
  jacobian_step_ = state_.step;
  jacobian_fixed_.clear();
  for (const PrescribedRow& row : constraints_.prescribed())
    jacobian_fixed_.push_back(row.row);
}

bool CoupledProblem::jacobian_lasts() const {
  const auto& rows = constraints_.prescribed();
  const bool same =
      std::equal(rows.begin(), rows.end(), jacobian_fixed_.begin(), jacobian_fixed_.end(),
                 [](const PrescribedRow& row, LocalIndex fixed) { return row.row == fixed; });
  constexpr double about = 1.3;
  const bool near = state_.step == jacobian_step_ ||
                    (state_.step < about * jacobian_step_ && jacobian_step_ < about * state_.step);
  return assembler_.dofs().mesh().communicator.sum(same && near ? 0LL : 1LL) == 0;
}

}  // namespace hawser
