#include "hawser/time/time_integrator.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
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
  is_partner_.assign(rule_.size(), 0);
  for (const auto& pair : assembler.kinematic_pairs())
    is_partner_[static_cast<std::size_t>(pair.velocity)] = 1;
}

void TimeIntegrator::start(const State& initial) {
  history_ = {};
  history_.time = history_.instant = initial.time;
  history_.value = initial.value;
  history_.rate = history_.quotient = history_.earlier_rate = initial.rate;
}

void TimeIntegrator::resume(TimeHistory history) { history_ = std::move(history); }

void TimeIntegrator::begin_step(double step, State& state) {
  const std::size_t rows = rule_.size();
  const bool steady = scheme_.steady();
  step_ = step;
  present_ = scheme_.coefficients(step, history_.step);
  state.step = steady ? std::numeric_limits<double>::infinity() : step;
  state.time = history_.time + present_.alpha_f * step;
  state.elapsed = steady ? state.step : state.time - history_.instant;
  state.share = steady ? 1 : present_.alpha_f;
  state.bounds_energy = present_.bounds_energy;
  state.accepted = history_.value;
  state.value = history_.value;
  state.rate.assign(rows, 0);
  state.rate_slope.assign(rows, 0);
  state.rate_partner.assign(rows, 0);
  known_rate_.assign(rows, 0);
  bend_.assign(rows, 0);
  const double reach = present_.alpha_f * step;  // s, from t_n to the instant of the equations
  const double beyond = (2 * present_.alpha_f - 1) * present_.memory;
  const double backward = present_.backward ? present_.memory : 0;
  const double share = present_.alpha_m / present_.gamma;
  for (std::size_t row = 0; row < rows && !steady; ++row) {
    // The first iterate goes on as the last step did.
    if (rule_[row] != RateRule::none && !is_structure(row))
      state.value[row] += reach * history_.quotient[row];
    if (rule_[row] == RateRule::dynamic) {
      state.rate_slope[row] = share * (1 + backward) / reach;
      known_rate_[row] = (1 - share) * history_.rate[row] - backward * history_.quotient[row];
    } else if (rule_[row] == RateRule::quotient && !is_structure(row)) {
      state.rate_slope[row] = (1 + beyond) / reach;
      known_rate_[row] = -beyond * history_.quotient[row];
    }
  }
  kinematics_.at_rest = steady;
  kinematics_.factor = steady ? 0 : step * present_.factor;
  kinematics_.known.clear();
  for (const auto& pair : assembler_.kinematic_pairs()) {
    const auto d = static_cast<std::size_t>(pair.displacement);
    const auto v = static_cast<std::size_t>(pair.velocity);
    kinematics_.known.push_back(
        steady ? history_.value[d]
               : history_.value[d] + step * (present_.of_velocity * history_.value[v] +
                                             present_.of_displacement_rate * history_.rate[d] +
                                             present_.of_quotient * history_.quotient[d] +
                                             step * present_.of_acceleration * history_.rate[v]));
    state.rate_partner[d] = 1;
    state.value[d] = kinematics_.known.back() + kinematics_.factor * state.value[v];
  }
  if (steady) return;
  update_rates(state);
}

void TimeIntegrator::update_rates(State& state) const {
  for (std::size_t row = 0; row < rule_.size(); ++row) {
    const double change = state.value[row] - bend_[row] - history_.value[row];
    state.rate[row] = is_structure(row) ? state.value[static_cast<std::size_t>(partner_[row])]
                                        : state.rate_slope[row] * change + known_rate_[row];
  }
}

void TimeIntegrator::set_bend(LocalIndex row, double at_instant, double at_end) {
  const auto r = static_cast<std::size_t>(row);
  if (rule_[r] == RateRule::none) return;
  const double past = history_.value[r];
  bend_[r] = at_instant - past - present_.alpha_f * (at_end - past);
}

// Not to be rounded where there is nothing to extrapolate.
double TimeIntegrator::end_value(const State& state, std::size_t row) const {
  if (rule_[row] == RateRule::none || present_.alpha_f == 1) return state.value[row];
  return history_.value[row] +
         (state.value[row] - bend_[row] - history_.value[row]) / present_.alpha_f;
}

double TimeIntegrator::end_rate(const State& state, std::size_t row) const {
  if (scheme_.steady() || rule_[row] == RateRule::none) return 0;
  if (rule_[row] == RateRule::quotient && !is_structure(row)) {
    const double quotient = (end_value(state, row) - history_.value[row]) / step_;
    return quotient + present_.memory * (quotient - history_.quotient[row]);
  }
  if (present_.alpha_m == 1) return state.rate[row];
  return history_.rate[row] + (state.rate[row] - history_.rate[row]) / present_.alpha_m;
}

void TimeIntegrator::extrapolate(const State& state, State& end) const {
  end = state;
  end.time = history_.time + step_;
  end.share = 1;
  for (std::size_t row = 0; row < rule_.size(); ++row) {
    end.value[row] = end_value(state, row);
    end.rate[row] = end_rate(state, row);
  }
}

void TimeIntegrator::accept(const State& state) {
  State end;
  extrapolate(state, end);
  for (std::size_t row = 0; row < rule_.size(); ++row)
    if (rule_[row] != RateRule::none)
      history_.quotient[row] =
          scheme_.steady() ? 0 : (end.value[row] - history_.value[row]) / step_;
  history_.time = end.time;
  history_.instant = state.time;
  history_.earlier_step = history_.step;
  history_.step = step_;
  history_.value = std::move(end.value);
  history_.earlier_rate = std::move(history_.rate);
  history_.rate = std::move(end.rate);
}

std::optional<double> TimeIntegrator::local_error(const State& state) const {
  if (history_.earlier_step == 0 || scheme_.steady()) return std::nullopt;
  // u_{n+1} against u_n + dt (u'_n + (r/2 + alpha_m - alpha_f) (u'_n - u'_{n-1})), r = dt/dt_n: a
  // rate of generalised-alpha is that of the time (alpha_m - alpha_f) dt_n before, one of the
  // midpoint rule that of half a step before.
  const double ratio = step_ / history_.step;
  const double reach =
      0.5 * ratio + (present_.bounds_energy ? 0.5 : present_.alpha_m - present_.alpha_f);
  const DofMap& dofs = assembler_.dofs();
  struct Sums {
    double value = 0, rate = 0, error[2] = {0, 0}, count[2] = {0, 0};  // [on structures]
  };
  constexpr int width = sizeof(Sums) / sizeof(double);
  std::vector<Sums> sums(dofs.fields().size());
  for (LocalIndex owned = 0; owned < dofs.owned(); ++owned) {
    const auto row = static_cast<std::size_t>(owned);
    if (rule_[row] != RateRule::dynamic) continue;
    const double change = history_.rate[row] - history_.earlier_rate[row];
    const double explicit_value =
        history_.value[row] + step_ * (history_.rate[row] + reach * change);
    const double error = end_value(state, row) - explicit_value;
    const double value = history_.value[row], rate = step_ * history_.rate[row];
    Sums& field = sums[static_cast<std::size_t>(dofs.info(owned).field)];
    field.value += value * value;
    field.rate += rate * rate;
    const int part = is_partner_[row] ? 1 : 0;
    field.error[part] += error * error;
    field.count[part] += 1;
  }
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), width * static_cast<int>(sums.size()), MPI_DOUBLE,
                MPI_SUM, dofs.mesh().communicator.mpi());
  double worst = 0;
  for (const Sums& field : sums) {
    const double scale = (field.value + field.rate) / (field.count[0] + field.count[1]);
    for (int part = 0; part < 2; ++part)
      if (field.count[part] > 0 && scale > 0)
        worst = std::max(worst, std::sqrt(field.error[part] / field.count[part] / scale));
  }
  return scheme_.error_share(ratio) * worst;
}

}  // namespace hawser
