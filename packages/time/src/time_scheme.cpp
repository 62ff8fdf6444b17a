#include "hawser/time/time_scheme.hpp"

namespace hawser {
namespace {

/// d' = q + s (q - q_n) = v, solved for d.
void set_backward(StepCoefficients& result, double memory) {
  result.backward = true;
  result.memory = memory;
  result.of_velocity = 0;
  result.of_quotient = memory / (1 + memory);
  result.factor = 1 / (1 + memory);
}

}  // namespace

int TimeScheme::order() const {
  const bool first =
      (method == Method::newmark && gamma != 0.5) || (method == Method::midpoint && theta != 0.5);
  return first ? 1 : 2;
}

StepCoefficients TimeScheme::coefficients(double step, double earlier) const {
  const bool euler = earlier == 0 && euler_start;
  StepCoefficients result;
  result.memory = step / (step + earlier);
  if (method == Method::bdf2) {
    set_backward(result, euler ? 0 : result.memory);
  } else if (method == Method::midpoint) {
    // All rates are differences over the step: m (v_1 - v_0) . v_theta is the gain of the kinetic
    // energy, and (theta - 1/2) m |v_1 - v_0|^2 more.
    result.alpha_f = theta;
    result.of_velocity = 0;
    result.factor = theta;
    result.bounds_energy = true;
  } else if (euler) {
    return result;
  } else if (method == Method::generalised_alpha) {
    // Jansen, Whiting & Hulbert, Comput. Methods Appl. Mech. Engrg. 190 (2000) 305-319, for
    // first-order systems. The structure is one too, with d' = v as its second equation (Kadapa,
    // Dettmer & Peric, Comput. Struct. 193 (2017) 226-238): one alpha_m suits all the shared rows.
    result.alpha_m = 0.5 * (3 - rho_infinity) / (1 + rho_infinity);
    result.alpha_f = 1 / (1 + rho_infinity);
    result.gamma = 0.5 + result.alpha_m - result.alpha_f;
    const double share = result.gamma / result.alpha_m;
    result.of_velocity = 0;
    result.of_displacement_rate = result.alpha_f * (1 - share);
    result.factor = result.alpha_f * share;
  } else {
    const double b = beta / gamma;
    result.gamma = gamma;
    result.of_velocity = 1 - b;
    result.of_acceleration = 0.5 - b;
    result.factor = b;
  }
  return result;
}

// With r = dt/dt_n the explicit step errs by (2 + 3/r)/12 dt^3 u''', the trapezoidal rule by -1/12
// and BDF2 by -(1 + r)^2/(6 r (1 + 2 r)) of it. A first-order scheme's error is all of the
// difference.
double TimeScheme::error_share(double ratio) const {
  if (order() == 1) return 1;
  if (method != Method::bdf2) return 1 / (3 * (1 + 1 / ratio));
  const double own = 2 * (1 + ratio) * (1 + ratio);
  return own / (own + (3 + 2 * ratio) * (1 + 2 * ratio));
}

}  // namespace hawser
