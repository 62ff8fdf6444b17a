#include "hawser/time/time_scheme.hpp"

namespace hawser {

int TimeScheme::order() const { return method == Method::newmark && gamma != 0.5 ? 1 : 2; }

StepCoefficients TimeScheme::coefficients() const {
  StepCoefficients result;
  if (method == Method::generalised_alpha) {
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

}  // namespace hawser
