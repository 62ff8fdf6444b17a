// Rates of motions that the scheme must reproduce to round-off, with steps of changing length.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "time/tests/sample_integrator.hpp"

namespace hawser {
namespace {

/// Every velocity and displacement follows a function of time: with speed(t) and way(t).
template <class Speed, class Way>
class Motion : private SampleIntegrator {
 public:
  Motion(const TimeScheme& scheme, Speed speed, Way way)
      : SampleIntegrator(scheme), speed_(speed), way_(way) {}

  /// Starts with the given rates of speed and way.
  void start(double speed_rate, double way_rate) {
    const auto rows = static_cast<std::size_t>(dofs.rows());
    state.time = 0;
    state.value.resize(rows);
    state.rate.resize(rows);
    for (std::size_t row = 0; row < rows; ++row) {
      state.value[row] = is_velocity(row) ? speed_(0.0) : way_(0.0);
      state.rate[row] = is_velocity(row) ? speed_rate : way_rate;
    }
    integrator.start(state);
  }
  void step(double length) {
    integrator.begin_step(length, state);
    for (std::size_t row = 0; row < state.value.size(); ++row)
      state.value[row] = is_velocity(row) ? speed_(state.time) : way_(state.time);
    integrator.update_rates(state);
    integrator.accept(state);
  }

  /// Largest |rate - wanted| of the velocity, or of the mesh's displacement away from the cable.
  double error_of_velocity_rate(double wanted) const {
    return largest(
        [&](std::size_t row) { return is_velocity(row) ? state.rate[row] - wanted : 0; });
  }
  double error_of_mesh_velocity(double wanted) const {
    return largest([&](std::size_t row) {
      return is_velocity(row) || is_structure(row) ? 0 : state.rate[row] - wanted;
    });
  }
  double error_of_structure_velocity() const {
    return largest([&](std::size_t row) {
      return is_structure(row) ? state.rate[row] - speed_(state.time) : 0;
    });
  }
  /// |known + factor v - d| on the cable, from the relation of the last step.
  double error_of_kinematics() const {
    const Kinematics& kinematics = integrator.kinematics();
    double worst = 0;
    for (const double known : kinematics.known)
      worst = std::max(worst,
                       std::abs(known + kinematics.factor * speed_(state.time) - way_(state.time)));
    EXPECT_EQ(kinematics.known.size(), 6U);
    return worst;
  }
  double time() const { return state.time; }
  double step_of_state() const { return state.step; }

 private:
  bool is_velocity(std::size_t row) const {
    return dofs.info(static_cast<LocalIndex>(row)).field == dofs.find("velocity");
  }
  bool is_structure(std::size_t row) const {
    double x[2];
    dofs.position(static_cast<LocalIndex>(row), x);
    return !is_velocity(row) && x[1] == 1;
  }
  template <class Error>
  double largest(Error&& error) const {
    double worst = 0;
    for (std::size_t row = 0; row < state.value.size(); ++row)
      worst = std::max(worst, std::abs(error(row)));
    return worst;
  }

  Speed speed_;
  Way way_;
};

const double lengths[] = {0.1, 0.1, 0.05, 0.2, 0.1};

TimeScheme bdf2() {
  TimeScheme scheme;
  scheme.method = TimeScheme::Method::bdf2;
  scheme.euler_start = false;
  return scheme;
}

TEST(NewmarkAndBdf2, ReproduceConstantAcceleration) {
  for (const TimeScheme& scheme : {newmark(0.25, 0.5), newmark(0.3025, 0.6), bdf2()}) {
    Motion motion(
        scheme, [](double t) { return 3 * t; }, [](double t) { return 1.5 * t * t; });
    motion.start(3, 0);
    for (const double length : lengths) {
      motion.step(length);
      EXPECT_LE(motion.error_of_velocity_rate(3), 1e-12);
      EXPECT_LE(motion.error_of_mesh_velocity(3 * motion.time()), 1e-12);
      EXPECT_LE(motion.error_of_kinematics(), 1e-14);
      EXPECT_EQ(motion.error_of_structure_velocity(), 0);
    }
  }
}

// Velocities that the conditions give, with a kink: what Newmark's method remembers of it for ever
// at gamma = 1/2, the accelerations of backward differences have forgotten after two steps.
TEST(Bdf2, ForgetsAKinkAfterTwoSteps) {
  const auto accelerations = [](const TimeScheme& scheme) {
    Motion motion(
        scheme, [](double t) { return t < 0.18 ? t : 0.18; }, [](double) { return 0.0; });
    motion.start(1, 0);
    for (int n = 0; n < 3; ++n)
      motion.step(0.1);
    double largest = 0;
    for (int n = 0; n < 1000; ++n) {
      motion.step(0.1);
      largest = std::max(largest, motion.error_of_velocity_rate(0));
    }
    return largest;
  };
  EXPECT_EQ(accelerations(bdf2()), 0);
  EXPECT_GT(accelerations(newmark(0.25, 0.5)), 0.4);
}

TEST(Bdf2, StartsWithImplicitEuler) {
  TimeScheme scheme = bdf2();
  scheme.euler_start = true;
  Motion motion(
      scheme, [](double t) { return t * t; }, [](double t) { return t * t * t; });
  motion.start(7, 7);  // not looked at
  motion.step(0.1);
  EXPECT_NEAR(motion.error_of_velocity_rate(0.1), 0, 1e-15);
  EXPECT_NEAR(motion.error_of_mesh_velocity(0.01), 0, 1e-15);
  EXPECT_NEAR(motion.error_of_kinematics(), 0, 1e-15);
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
  EXPECT_EQ(motion.step_of_state(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace hawser
