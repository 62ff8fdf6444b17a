// Rates of motions that the scheme must reproduce to round-off, with steps of changing length.
#include "hawser/time/time_integrator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/field_table.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

/// Water whose mesh moves, and a cable through its middle.
std::vector<PhysicsModule> sample_modules() {
  std::vector<PhysicsModule> modules;
  modules.push_back(module_with(
      "flow",
      std::make_unique<LoadKernel>(
          "water", 3, std::vector<FieldUse>{velocity(Role::adds), displacement(Role::governs)})));
  modules.push_back(module_with(
      "cable",
      std::make_unique<LoadKernel>(
          "cable", 2, std::vector<FieldUse>{velocity(Role::adds), displacement(Role::kinematic)})));
  return modules;
}

Mesh sample_mesh() {
  MeshText text = grid(2, 2);
  text.groups.push_back(line("cable", {3, 4, 5}));
  return read_text(Communicator(), text.in_format("4.1"));
}

/// Every velocity and displacement follows a function of time: with speed(t) and way(t).
template <class Speed, class Way>
class Motion {
 public:
  Motion(const TimeScheme& scheme, Speed speed, Way way)
      : mesh_(sample_mesh()),
        modules_(sample_modules()),
        table_(gather_fields(modules_)),
        dofs_(mesh_, table_.fields),
        assembler_(dofs_, modules_),
        integrator_(assembler_, table_.rate_rules, scheme),
        speed_(speed),
        way_(way) {}

  /// Starts with the given rates of speed and way.
  void start(double speed_rate, double way_rate) {
    const auto rows = static_cast<std::size_t>(dofs_.rows());
    state_.time = 0;
    state_.value.resize(rows);
    state_.rate.resize(rows);
    for (std::size_t row = 0; row < rows; ++row) {
      state_.value[row] = is_velocity(row) ? speed_(0.0) : way_(0.0);
      state_.rate[row] = is_velocity(row) ? speed_rate : way_rate;
    }
    integrator_.start(state_);
  }
  void step(double length) {
    integrator_.begin_step(length, state_);
    for (std::size_t row = 0; row < state_.value.size(); ++row)
      state_.value[row] = is_velocity(row) ? speed_(state_.time) : way_(state_.time);
    integrator_.update_rates(state_);
    integrator_.accept(state_);
  }

  /// Largest |rate - wanted| of the velocity, or of the mesh's displacement away from the cable.
  double error_of_velocity_rate(double wanted) const {
    return largest(
        [&](std::size_t row) { return is_velocity(row) ? state_.rate[row] - wanted : 0; });
  }
  double error_of_mesh_velocity(double wanted) const {
    return largest([&](std::size_t row) {
      return is_velocity(row) || is_structure(row) ? 0 : state_.rate[row] - wanted;
    });
  }
  double error_of_structure_velocity() const {
    return largest([&](std::size_t row) {
      return is_structure(row) ? state_.rate[row] - speed_(state_.time) : 0;
    });
  }
  /// |known + factor v - d| on the cable, from the relation of the last step.
  double error_of_kinematics() const {
    const Kinematics& kinematics = integrator_.kinematics();
    double worst = 0;
    for (const double known : kinematics.known)
      worst = std::max(
          worst, std::abs(known + kinematics.factor * speed_(state_.time) - way_(state_.time)));
    EXPECT_EQ(kinematics.known.size(), 6U);
    return worst;
  }
  const State& state() const { return state_; }

 private:
  bool is_velocity(std::size_t row) const {
    return dofs_.info(static_cast<LocalIndex>(row)).field == dofs_.find("velocity");
  }
  bool is_structure(std::size_t row) const {
    double x[2];
    dofs_.position(static_cast<LocalIndex>(row), x);
    return !is_velocity(row) && x[1] == 1;
  }
  template <class Error>
  double largest(Error&& error) const {
    double worst = 0;
    for (std::size_t row = 0; row < state_.value.size(); ++row)
      worst = std::max(worst, std::abs(error(row)));
    return worst;
  }

  Mesh mesh_;
  std::vector<PhysicsModule> modules_;
  FieldTable table_;
  DofMap dofs_;
  Assembler assembler_;
  TimeIntegrator integrator_;
  Speed speed_;
  Way way_;
  State state_;
};

TimeScheme newmark(double beta, double gamma) {
  TimeScheme scheme;
  scheme.beta = beta, scheme.gamma = gamma;
  scheme.euler_start = false;
  return scheme;
}
TimeScheme generalised_alpha(double rho_infinity) {
  TimeScheme scheme;
  scheme.method = TimeScheme::Method::generalised_alpha;
  scheme.rho_infinity = rho_infinity;
  return scheme;
}

/// The cable's nodes as oscillators v' + omega^2 d = 0, d' = v, from d = 1, v = 0, with an initial
/// acceleration that is wrong; the water's nodes obey v' + omega v = 0 from v = 1.
class Oscillators {
 public:
  Oscillators(const TimeScheme& scheme, double omega)
      : omega_(omega),
        mesh_(sample_mesh()),
        modules_(sample_modules()),
        table_(gather_fields(modules_)),
        dofs_(mesh_, table_.fields),
        assembler_(dofs_, modules_),
        integrator_(assembler_, table_.rate_rules, scheme) {
    const auto rows = static_cast<std::size_t>(dofs_.rows());
    state_.value.assign(rows, 0);
    state_.rate.assign(rows, 0);
    for (const auto& pair : assembler_.kinematic_pairs()) {
      oscillating_.push_back(static_cast<std::size_t>(pair.velocity));
      displacement_ = static_cast<std::size_t>(pair.displacement);
      velocity_ = static_cast<std::size_t>(pair.velocity);
      state_.value[displacement_] = 1;
    }
    for (std::size_t row = 0; row < rows; ++row)
      if (dofs_.info(static_cast<LocalIndex>(row)).field == dofs_.find("velocity") &&
          std::find(oscillating_.begin(), oscillating_.end(), row) == oscillating_.end()) {
        decaying_ = row;
        state_.value[row] = 1;
      }
    integrator_.start(state_);
  }

  void step(double length) {
    integrator_.begin_step(length, state_);
    const auto balance = [&](double v) {
      state_.value[velocity_] = state_.value[decaying_] = v;
      const auto& pairs = assembler_.kinematic_pairs();
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if (static_cast<std::size_t>(pairs[i].displacement) == displacement_)
          state_.value[displacement_] =
              integrator_.kinematics().known[i] + integrator_.kinematics().factor * v;
      integrator_.update_rates(state_);
      return std::array<double, 2>{
          state_.rate[velocity_] + omega_ * omega_ * state_.value[displacement_],
          state_.rate[decaying_] + omega_ * v};
    };
    const auto at_zero = balance(0), at_one = balance(1);
    double solution[2];
    for (std::size_t i = 0; i < 2; ++i)
      solution[i] = at_zero[i] / (at_zero[i] - at_one[i]);
    balance(solution[0]);
    state_.value[decaying_] = solution[1];
    integrator_.update_rates(state_);
    error_ = integrator_.local_error(state_);
    integrator_.accept(state_);
  }
  void run(double length, double end) {
    const long steps = std::lround(end / length);
    for (long n = 0; n < steps; ++n)
      step(length);
  }

  double displacement() const { return integrator_.history().value[displacement_]; }
  double velocity() const { return integrator_.history().value[velocity_]; }
  double decaying() const { return integrator_.history().value[decaying_]; }
  std::optional<double> local_error() const { return error_; }

 private:
  double omega_;
  Mesh mesh_;
  std::vector<PhysicsModule> modules_;
  FieldTable table_;
  DofMap dofs_;
  Assembler assembler_;
  TimeIntegrator integrator_;
  State state_;
  std::vector<std::size_t> oscillating_;
  std::size_t displacement_ = 0, velocity_ = 0, decaying_ = 0;
  std::optional<double> error_;
};

/// Of displacement, velocity and the decaying value at t = 2 from the errors with two steps.
std::array<double, 3> orders(const TimeScheme& scheme) {
  std::array<double, 3> errors[2];
  for (int fine = 0; fine < 2; ++fine) {
    Oscillators oscillators(scheme, 2);
    oscillators.run(fine == 1 ? 0.005 : 0.01, 2);
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
       {newmark(0.25, 0.5), generalised_alpha(0.5), newmark(0.3025, 0.6)}) {
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

const double lengths[] = {0.1, 0.1, 0.05, 0.2, 0.1};

TEST(Newmark, ReproducesConstantAcceleration) {
  for (const TimeScheme& scheme : {newmark(0.25, 0.5), newmark(0.3025, 0.6)}) {
    Motion motion(
        scheme, [](double t) { return 3 * t; }, [](double t) { return 1.5 * t * t; });
    motion.start(3, 0);
    for (const double length : lengths) {
      motion.step(length);
      EXPECT_LE(motion.error_of_velocity_rate(3), 1e-12);
      EXPECT_LE(motion.error_of_mesh_velocity(3 * motion.state().time), 1e-12);
      EXPECT_LE(motion.error_of_kinematics(), 1e-14);
      EXPECT_EQ(motion.error_of_structure_velocity(), 0);
    }
  }
}

TEST(Newmark, IsOfSecondOrderWithGammaOneHalfAndOfFirstAbove) {
  const auto error_with = [](double gamma, double length) {
    Motion motion(
        newmark(0.3025, gamma), [](double t) { return std::sin(t); },
        [](double t) { return std::sin(t); });
    motion.start(1, 1);
    const int steps = static_cast<int>(std::lround(1 / length));
    for (int n = 0; n < steps; ++n)
      motion.step(length);
    return motion.error_of_velocity_rate(std::cos(1.0));
  };
  EXPECT_NEAR(std::log2(error_with(0.5, 0.02) / error_with(0.5, 0.01)), 2, 0.1);
  EXPECT_NEAR(std::log2(error_with(0.6, 0.02) / error_with(0.6, 0.01)), 1, 0.1);
}

TEST(MeshVelocity, IsOfSecondOrderWhateverGamma) {
  const auto error_with = [](double length) {
    Motion motion(
        newmark(0.3025, 0.6), [](double) { return 0.0; }, [](double t) { return std::sin(t); });
    motion.start(0, 1);
    const int steps = static_cast<int>(std::lround(1 / length));
    for (int n = 0; n < steps; ++n)
      motion.step(length);
    return motion.error_of_mesh_velocity(std::cos(1.0));
  };
  EXPECT_NEAR(std::log2(error_with(0.02) / error_with(0.01)), 2, 0.1);
}

TEST(MeshVelocity, ForgetsAKinkAfterTwoSteps) {
  Motion motion(
      newmark(0.25, 0.5), [](double) { return 0.0; }, [](double t) { return t < 0.15 ? t : 0.1; });
  motion.start(0, 1);
  motion.step(0.1);
  EXPECT_LE(motion.error_of_mesh_velocity(1), 1e-14);
  motion.step(0.1);
  EXPECT_GT(motion.error_of_mesh_velocity(0), 0.1);
  motion.step(0.1);
  EXPECT_EQ(motion.error_of_mesh_velocity(0), 0);
}

TEST(Steady, HasNoRates) {
  TimeScheme steady;
  steady.method = TimeScheme::Method::steady;
  Motion motion(
      steady, [](double t) { return t; }, [](double t) { return t; });
  motion.start(1, 1);
  motion.step(1);
  EXPECT_EQ(motion.error_of_velocity_rate(0), 0);
  EXPECT_EQ(motion.error_of_mesh_velocity(0), 0);
  EXPECT_EQ(motion.state().step, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace hawser
