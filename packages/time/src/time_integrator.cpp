#include "hawser/time/time_integrator.hpp"

#include <limits>

namespace hawser {

TimeIntegrator::TimeIntegrator(const Assembler& assembler, const std::vector<RateRule>& rules,
                               const TimeScheme& scheme)
    : assembler_(assembler), scheme_(scheme) {
  const DofMap& dofs = assembler.dofs();
  for (LocalIndex row = 0; row < dofs.rows(); ++row)
    rule_.push_back(rules[static_cast<std::size_t>(dofs.info(row).field)]);
  partner_.assign(rule_.size(), -1);
  for (const auto& pair : assembler.kinematic_pairs())
    partner_[static_cast<std::size_t>(pair.displacement)] = pair.velocity;
}

void TimeIntegrator::start(const State& initial) {
  history_ = {initial.time, 0, initial.value, initial.rate, initial.rate};
}

void TimeIntegrator::resume(TimeHistory history) { history_ = std::move(history); }

void TimeIntegrator::begin_step(double step, State& state) {
  const std::size_t rows = rule_.size();
  step_ = step;
  state.step = scheme_.steady ? std::numeric_limits<double>::infinity() : step;
  state.time = history_.time + step;
  state.accepted = history_.value;
  state.value = history_.value;
  state.rate.assign(rows, 0);
  state.rate_slope.assign(rows, 0);
  state.rate_partner.assign(rows, 0);
  kinematics_.factor = scheme_.steady ? 0 : step * scheme_.beta / scheme_.gamma;
  kinematics_.known.clear();
  const double share = step / (step + history_.step);
  const double b = scheme_.beta / scheme_.gamma;
  for (const auto& pair : assembler_.kinematic_pairs()) {
    const auto d = static_cast<std::size_t>(pair.displacement);
    const auto v = static_cast<std::size_t>(pair.velocity);
    kinematics_.known.push_back(scheme_.steady
                                    ? history_.value[d]
                                    : history_.value[d] + step * (1 - b) * history_.value[v] +
                                          step * step * (0.5 - b) * history_.rate[v]);
    state.rate_partner[d] = 1;
    state.value[d] = kinematics_.known.back() + kinematics_.factor * history_.value[v];
  }
  if (scheme_.steady) return;
  for (std::size_t row = 0; row < rows; ++row) {
    if (rule_[row] == RateRule::dynamic)
      state.rate_slope[row] = 1 / (scheme_.gamma * step);
    else if (rule_[row] == RateRule::quotient && !is_structure(row)) {
      state.rate_slope[row] = (1 + share) / step;
      state.value[row] += step * history_.quotient[row];
    }
  }
  update_rates(state);
}

void TimeIntegrator::update_rates(State& state) const {
  for (std::size_t row = 0; row < rule_.size(); ++row) {
    if (is_structure(row))
      state.rate[row] = state.value[static_cast<std::size_t>(partner_[row])];
    else if (scheme_.steady || rule_[row] == RateRule::none)
      state.rate[row] = 0;
    else if (rule_[row] == RateRule::dynamic)
      state.rate[row] = state.rate_slope[row] * (state.value[row] - history_.value[row]) -
                        (1 - scheme_.gamma) / scheme_.gamma * history_.rate[row];
    else
      state.rate[row] = state.rate_slope[row] * (state.value[row] - history_.value[row]) -
                        step_ / (step_ + history_.step) * history_.quotient[row];
  }
}

void TimeIntegrator::accept(const State& state) {
  for (std::size_t row = 0; row < rule_.size(); ++row)
    if (rule_[row] == RateRule::quotient)
      history_.quotient[row] =
          scheme_.steady ? 0 : (state.value[row] - history_.value[row]) / step_;
  history_.time = state.time;
  history_.step = step_;
  history_.value = state.value;
  history_.rate = state.rate;
}

}  // namespace hawser
