// Orders, damping and the estimate of the local error, on equations that are solved.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "time/tests/sample_integrator.hpp"

namespace hawser {
namespace {

TimeScheme generalised_alpha(double rho_infinity) {
  TimeScheme scheme;
  scheme.method = TimeScheme::Method::generalised_alpha;
  scheme.rho_infinity = rho_infinity;
  return scheme;
}

TimeScheme bdf2() {
  TimeScheme scheme;
  scheme.method = TimeScheme::Method::bdf2;
  return scheme;
}

TimeScheme midpoint(double theta) {
  TimeScheme scheme;
  scheme.method = TimeScheme::Method::midpoint;
  scheme.theta = theta;
  return scheme;
}

/// The cable's nodes as oscillators v' + omega^2 d = 0, d' = v, from d = 1, v = 0, with an initial
/// acceleration that is wrong; the water's nodes obey v' + omega v = 0 from v = 1.
class Oscillators : private SampleIntegrator {
 public:
  Oscillators(const TimeScheme& scheme, double omega) : SampleIntegrator(scheme), omega_(omega) {
    const auto rows = static_cast<std::size_t>(dofs.rows());
    state.value.assign(rows, 0);
    state.rate.assign(rows, 0);
    for (const auto& pair : assembler.kinematic_pairs()) {
      oscillating_.push_back(static_cast<std::size_t>(pair.velocity));
      displacement_ = static_cast<std::size_t>(pair.displacement);
      velocity_ = static_cast<std::size_t>(pair.velocity);
      state.value[displacement_] = 1;
    }
    for (std::size_t row = 0; row < rows; ++row)
      if (dofs.info(static_cast<LocalIndex>(row)).field == dofs.find("velocity") &&
          std::find(oscillating_.begin(), oscillating_.end(), row) == oscillating_.end()) {
        decaying_ = row;
        state.value[row] = 1;
      }
    integrator.start(state);
  }

  void step(double length) {
    integrator.begin_step(length, state);
    const auto balance = [&](double v) {
      state.value[velocity_] = state.value[decaying_] = v;
      const auto& pairs = assembler.kinematic_pairs();
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if (static_cast<std::size_t>(pairs[i].displacement) == displacement_)
          state.value[displacement_] =
              integrator.kinematics().known[i] + integrator.kinematics().factor * v;
      integrator.update_rates(state);
      return std::array<double, 2>{
          state.rate[velocity_] + omega_ * omega_ * state.value[displacement_],
          state.rate[decaying_] + omega_ * v};
    };
    const auto at_zero = balance(0), at_one = balance(1);
    double solution[2];
    for (std::size_t i = 0; i < 2; ++i)
      solution[i] = at_zero[i] / (at_zero[i] - at_one[i]);
    balance(solution[0]);
    state.value[decaying_] = solution[1];
    integrator.update_rates(state);
    error_ = integrator.local_error(state);
    integrator.accept(state);
  }
  void run(double length, double end) {
    const long steps = std::lround(end / length);
    for (long n = 0; n < steps; ++n)
      step(length);
  }
  /// Steps that double and halve: 4 `length` long together.
  void run_uneven(double length, double end) {
    const long rounds = std::lround(end / length / 4);
    for (long n = 0; n < rounds; ++n)
      for (const double share : {0.5, 1.0, 2.0, 0.5})
        step(share * length);
  }

  double displacement() const { return integrator.history().value[displacement_]; }
  double velocity() const { return integrator.history().value[velocity_]; }
  double decaying() const { return integrator.history().value[decaying_]; }
  std::optional<double> local_error() const { return error_; }

 private:
  double omega_;
  std::vector<std::size_t> oscillating_;
  std::size_t displacement_ = 0, velocity_ = 0, decaying_ = 0;
  std::optional<double> error_;
};

/// Of displacement, velocity and the decaying value at t = 2 from the errors with two steps.
std::array<double, 3> orders(const TimeScheme& scheme, bool uneven = false) {
  std::array<double, 3> errors[2];
  for (int fine = 0; fine < 2; ++fine) {
    Oscillators oscillators(scheme, 2);
    const double length = fine == 1 ? 0.005 : 0.01;
    uneven ? oscillators.run_uneven(length, 2) : oscillators.run(length, 2);
    errors[fine] = {std::abs(oscillators.displacement() - std::cos(4.0)),
                    std::abs(oscillators.velocity() + 2 * std::sin(4.0)),
                    std::abs(oscillators.decaying() - std::exp(-4.0))};
  }
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = std::log2(errors[0][i] / errors[1][i]);
  return result;
}

TEST(Order, IsThatOfTheScheme) {
  TimeScheme trapezoid = newmark(0.25, 0.5), damped = newmark(0.3025, 0.6);
  trapezoid.euler_start = damped.euler_start = true;
  for (const double order : orders(trapezoid))
    EXPECT_NEAR(order, 2, 0.1);
  for (const double rho : {0.0, 0.5, 0.9, 1.0})
    for (const double order : orders(generalised_alpha(rho)))
      EXPECT_NEAR(order, 2, 0.1) << "rho_infinity " << rho;
  for (const double order : orders(damped))
    EXPECT_NEAR(order, 1, 0.1);
  for (const bool uneven : {false, true}) {
    for (const double order : orders(midpoint(0.5), uneven))
      EXPECT_NEAR(order, 2, 0.1);
    for (const double order : orders(midpoint(0.6), uneven))
      EXPECT_NEAR(order, 1, 0.1);
    for (const double order : orders(bdf2(), uneven))
      EXPECT_NEAR(order, 2, 0.1) << (uneven ? "uneven steps" : "even steps");
  }
}

// L-stable: of motions that a step does not resolve nothing is left, also where steps grow.
TEST(Bdf2, LeavesNothingOfTheFastestMotions) {
  Oscillators oscillators(bdf2(), 1e7);
  oscillators.step(1);
  oscillators.step(1);
  oscillators.step(2);
  EXPECT_LE(std::abs(oscillators.displacement()), 1e-13);
  EXPECT_LE(std::abs(oscillators.decaying()), 1e-13);
}

// Zero-stable up to a growth of 1 + sqrt(2) per step (Grigorieff, Numer. Math. 42 (1983) 359-377);
// the step control allows 2.
TEST(Bdf2, IsStableWhileStepsDouble) {
  for (const double omega : {0.0, 1.0, 1e3}) {
    Oscillators oscillators(bdf2(), omega);
    for (double length = 1e-9; length < 1e3; length *= 2) {
      oscillators.step(length);
      EXPECT_LE(std::abs(oscillators.displacement()), 1 + 1e-3) << "omega " << omega;
      EXPECT_LE(std::abs(oscillators.decaying()), 1 + 1e-12) << "omega " << omega;
    }
    EXPECT_LE(std::abs(oscillators.decaying()), omega > 0 ? 1e-6 : 1) << "omega " << omega;
  }
}

// The error constants, on a cubic polynomial's exact past.
TEST(Bdf2, ItsErrorIsTheShareOfTheDifferenceToAnExplicitStep) {
  for (const double ratio : {0.5, 1.0, 2.0}) {
    const double earlier = 1 / ratio;  // of a step of 1 from t = 0 to 1; u = t^3
    const StepCoefficients present = bdf2().coefficients(1, earlier);
    const double s = present.memory, quotient = earlier * earlier;
    const double value = (3 + s * quotient) / (1 + s);
    const double explicit_value = 0.5 * ratio * (0 - 3 * earlier * earlier);
    EXPECT_NEAR(value - 1, bdf2().error_share(ratio) * (value - explicit_value), 1e-14);
  }
}

// From the first step on, though the initial acceleration is wrong, and for steps of any length.
TEST(Midpoint, KeepsTheEnergyOrLosesSome) {
  const auto energy = [](const Oscillators& oscillators, double omega) {
    return std::pow(omega * oscillators.displacement(), 2) + std::pow(oscillators.velocity(), 2);
  };
  for (const double omega : {0.1, 2.0, 1e4}) {
    Oscillators keeps(midpoint(0.5), omega), loses(midpoint(0.55), omega);
    double before = energy(loses, omega);
    for (const double length : {0.1, 0.1, 3.0, 0.7, 1e-3, 20.0}) {
      keeps.step(length);
      EXPECT_NEAR(energy(keeps, omega), omega * omega, 1e-11 * omega * omega);
      loses.step(length);
      EXPECT_LE(energy(loses, omega), before);
      before = energy(loses, omega);
    }
    EXPECT_LE(before, 0.9 * omega * omega);
  }
}

// What rho_infinity means, for structures and fluid with the one alpha_m.
TEST(GeneralisedAlpha, LeavesRhoInfinityOfTheFastestMotions) {
  for (const double rho : {0.3, 0.5, 0.8}) {
    Oscillators oscillators(generalised_alpha(rho), 1e7);
    oscillators.run(1, 60);
    const double d = oscillators.displacement(), decaying = oscillators.decaying();
    oscillators.run(1, 1);
    // Roots of multiplicity two and, for the oscillator, four: n rho^n and n^3 rho^n with n = 60.
    EXPECT_NEAR(std::abs(oscillators.decaying() / decaying), rho * 61 / 60, 0.01 * rho);
    EXPECT_NEAR(std::abs(oscillators.displacement() / d), rho * std::pow(61.0 / 60, 3), 0.01 * rho);
  }
}

// Within a factor of two of the true error of a step, for fluid-like and structure-like motion.
TEST(LocalError, IsEstimated) {
  for (const TimeScheme& scheme :
       {newmark(0.25, 0.5), generalised_alpha(0.5), newmark(0.3025, 0.6), bdf2(), midpoint(0.5)}) {
    Oscillators oscillators(scheme, 2);
    EXPECT_FALSE(oscillators.local_error());
    oscillators.run(0.01, 0.5);
    const double coarse = oscillators.local_error().value();
    Oscillators finer(scheme, 2);
    finer.run(0.005, 0.5);
    EXPECT_NEAR(std::log2(coarse / finer.local_error().value()), scheme.order() + 1, 0.15);
    if (scheme.method != TimeScheme::Method::newmark || scheme.order() != 2) continue;
    const double exact = std::pow(0.02, 3) / 12;  // of the trapezoidal rule, (omega dt)^3 / 12
    EXPECT_LE(coarse, 2 * exact);
    EXPECT_GE(coarse, exact / 4);
  }
}

}  // namespace
}  // namespace hawser
