#pragma once
// Which method steps through time, and its coefficients.

namespace hawser {

/// At which instants a step's equations are formed, as shares of the step, and what their rates and
/// the structures' displacements are made of (time_integrator.hpp).
struct StepCoefficients {
  double alpha_m = 1;  ///< of the rates
  double alpha_f = 1;  ///< of the values
  double gamma = 1;
  double memory = 1;           ///< s of a geometry's rate q + s (q - q_n); 0: nothing to remember
  bool backward = false;       ///< velocities and the like have that rate, too
  bool bounds_energy = false;  ///< CellInput::bounds_energy
  /// Displacement of structures: d_a = d_n + dt (of_velocity v_n + of_displacement_rate d'_n +
  /// of_quotient q_n) + dt^2 of_acceleration v'_n + dt factor v_a.
  double of_velocity = 0.5, of_displacement_rate = 0, of_quotient = 0, of_acceleration = 0,
         factor = 0.5;
};

struct TimeScheme {
  enum class Method { bdf2, newmark, generalised_alpha, midpoint, steady };
  Method method = Method::newmark;
  double beta = 0.3025;       ///< Newmark
  double gamma = 0.6;         ///< Newmark
  double rho_infinity = 0.5;  ///< generalised-alpha: what is left per step of the fastest motions
  double theta = 0.5;         ///< midpoint: where in the step the equations stand
  bool euler_start = true;    ///< the first step does not ask for initial rates

  bool steady() const { return method == Method::steady; }
  /// 2, or 1 for Newmark with gamma > 1/2 and for a midpoint beyond 1/2.
  int order() const;
  /// Of a step of length `step` after one of length `earlier` (s; 0 at the start).
  StepCoefficients coefficients(double step, double earlier) const;
  /// The local error of a step as a share of its difference to the explicit second-order step from
  /// the last two rates; `ratio` is the step over the one before.
  double error_share(double ratio) const;
};

}  // namespace hawser
