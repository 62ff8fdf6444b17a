#include "hawser/time/time_deck.hpp"

namespace hawser {
namespace {

Spec<StepTargets> adapt_spec() {
  using P = StepTargets;
  return Spec<P>("adapt",
                 "Steers the length of the steps; the same run twice takes the same steps.")
      .attribute(
          "error", &P::error, "1", between(0, 0.1),
          "Wanted local error of a step, relative to the field, of the fields with a dynamic "
          "rate; a step with more is repeated. 0 for no look at it.")
      .attribute("newton-iterations", &P::newton_iterations, between(0, 50),
                 "Wanted Newton iterations per step; 0 for no look at them.")
      .attribute("longest-step", &P::longest, "s", non_negative(),
                 "No step is longer; 0 for no such limit.")
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        if (p.error == 0 && p.newton_iterations == 0)
          diagnostics.error(where, "<adapt> needs error or newton-iterations, or both");
      });
}

}  // namespace

TimeScheme TimeDeck::scheme() const {
  TimeScheme result;
  result.method = method;
  result.beta = beta.value_or(result.beta);
  result.gamma = gamma.value_or(result.gamma);
  result.rho_infinity = rho_infinity.value_or(result.rho_infinity);
  result.theta = theta.value_or(result.theta);
  result.euler_start = euler_start;
  return result;
}

Spec<TimeDeck> TimeDeck::spec() {
  using P = TimeDeck;
  using Method = TimeScheme::Method;
  return Spec<P>("time", "Time stepping.")
      .source("doc/numerics.md")
      .choice("scheme", &P::method,
              {{"bdf2", Method::bdf2},
               {"newmark", Method::newmark},
               {"generalised-alpha", Method::generalised_alpha},
               {"midpoint", Method::midpoint},
               {"steady", Method::steady}},
              "Backward differences of second order, which damp fast motions at once; Newmark's "
              "method; generalised-alpha; the midpoint rule with forces from differences of "
              "energies, by which a structure gains no energy without work, whatever the step; or "
              "solves without rates: one at `end`, or, "
              "where `step` is shorter, one per step, in which loads may grow with t.")
      .attribute("beta", &P::beta, "1", between(0.25, 1) && absent("0.3025"), "Newmark's beta.")
      .attribute("gamma", &P::gamma, "1", between(0.5, 1) && absent("0.6"),
                 "Newmark's gamma. More than 0.5 damps and is first order; 0.5 "
                 "is second "
                 "order, but lets accelerations and forces ring after any kink in time.")
      .attribute("rho-infinity", &P::rho_infinity, "1", between(0, 1) && absent("0.5"),
                 "What generalised-alpha leaves of the fastest motions per step: 0 damps most, 1 "
                 "nothing.")
      .attribute("theta", &P::theta, "1", between(0.5, 1) && absent("0.5"),
                 "Where in the step the midpoint rule forms its equations: at 0.5 it keeps the "
                 "energy, beyond it loses some in every step and is of first order.")
      .choice("start", &P::euler_start, {{"implicit-euler", true}, {"initial-rates", false}},
              "How the first step is made: by implicit Euler, which asks for no initial rates, or "
              "by the scheme with the rates of the initial values' expressions (0 for constants).")
      .attribute("step", &P::step, "s", positive(),
                 "Length of a step; of the first one with <adapt>.")
      .attribute("least-step", &P::least, "s", non_negative(),
                 "A rejected step is halved down to this length; 0 for a thousandth of the step.")
      .attribute("end", &P::end, "s", positive(), "Time at which the run ends.")
      .attribute("grow-after", &P::grow_after, at_least(1),
                 "Accepted steps in a row after which a cut step is doubled again.")
      .attribute(
          "energy-growth", &P::energy_growth, "1", non_negative(),
          "A step is rejected in which the time scheme makes energy out of nothing, once all "
          "that it has made is more than this share of the work done and of the energy at "
          "the start; 0 to let it be.")
      .child(&P::targets, adapt_spec())
      .location(&P::location)
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        const TimeScheme scheme = p.scheme();
        if (p.method != Method::newmark && (p.beta || p.gamma))
          diagnostics.error(where, "beta and gamma belong to scheme=\"newmark\"");
        if (p.method != Method::generalised_alpha && p.rho_infinity)
          diagnostics.error(where, "rho-infinity belongs to scheme=\"generalised-alpha\"");
        if (p.method != Method::midpoint && p.theta)
          diagnostics.error(where, "theta belongs to scheme=\"midpoint\"");
        if (p.steady() && p.targets)
          diagnostics.error(where, "a steady solve has no steps that <adapt> could steer");
        if (2 * scheme.beta < scheme.gamma)
          diagnostics.error(where, "beta is " + write_value(scheme.beta) + " and gamma " +
                                       write_value(scheme.gamma) +
                                       ": Newmark's method is unstable; beta must be at least "
                                       "gamma/2");
        if (p.least > p.step)
          diagnostics.error(where, "least-step is " + write_value(p.least) +
                                       " s, longer than the step of " + write_value(p.step) + " s");
      });
}

}  // namespace hawser
