#include "hawser/values/smoothing_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hawser/base/constants.hpp"

namespace hawser {
namespace {

std::vector<double> evenly(std::size_t count, double spacing) {
  std::vector<double> times(count);
  for (std::size_t i = 0; i < count; ++i)
    times[i] = spacing * static_cast<double>(i);
  return times;
}

template <class F>
std::vector<double> sampled(const std::vector<double>& times, const F& f) {
  std::vector<double> values;
  for (const double t : times)
    values.push_back(f(t));
  return values;
}

/// The amplitude that is left of a swing of `wave` s.
double left_of(double wave, double period) {
  const auto times = evenly(4001, 1);
  const SmoothingSpline spline(
      times, sampled(times, [&](double t) { return std::sin(2 * pi * t / wave); }), period);
  double greatest = 0;
  for (double t = 1500; t < 2500; t += 0.25)
    greatest = std::max(greatest, std::abs(spline.value(t)));
  return greatest;
}

class Response : public testing::TestWithParam<double> {};

// 1 / (1 + (period / wave)^4); rows of a second make out of swings of 20 s and more what time does,
// to a few in ten thousand.
TEST_P(Response, IsThatOfTheFilter) {
  const double wave = GetParam();
  EXPECT_NEAR(left_of(wave, 60), 1 / (1 + std::pow(60 / wave, 4)), 2e-3) << wave;
}
INSTANTIATE_TEST_SUITE_P(SmoothingSpline, Response,
                         testing::Values(20, 30, 40, 50, 60, 70, 80, 100, 150, 300, 1000));

TEST(SmoothingSpline, LeavesAStraightLineAlone) {
  const std::vector<double> times{0, 1, 3, 3.5, 10, 12, 20};
  const SmoothingSpline spline(times, sampled(times, [](double t) { return 2 - 0.3 * t; }), 100);
  for (double t = 0; t <= 20; t += 0.7) {
    EXPECT_NEAR(spline.value(t), 2 - 0.3 * t, 1e-10);
    EXPECT_NEAR(spline.rate(t), -0.3, 1e-10);
  }
}

TEST(SmoothingSpline, OfNoStrengthGoesThroughEveryRow) {
  const std::vector<double> times{0, 1, 3, 3.5, 10};
  const std::vector<double> values{1, -2, 4, 0, 3};
  const SmoothingSpline spline(times, values, 0);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(spline.value(times[i]), values[i], 1e-12);
}

TEST(SmoothingSpline, IsTwiceContinuouslyDifferentiable) {
  const std::vector<double> times{0, 1, 3, 3.5, 10, 11};
  const SmoothingSpline spline(times, {1, -2, 4, 0, 3, 2}, 2);
  const double h = 1e-5;
  for (std::size_t i = 1; i + 1 < times.size(); ++i) {
    const double t = times[i];
    EXPECT_NEAR(spline.rate(t - h), spline.rate(t + h), 1e-3);
    EXPECT_NEAR((spline.rate(t) - spline.rate(t - h)) / h,
                (spline.rate(t + h) - spline.rate(t)) / h, 1e-3);
    EXPECT_NEAR((spline.value(t + h) - spline.value(t - h)) / (2 * h), spline.rate(t), 1e-8);
  }
}

// Among all curves it is the least of what it is said to be the least of: moving any value at a row
// and interpolating makes it more.
TEST(SmoothingSpline, MinimisesWhatItIsSaidTo) {
  const std::vector<double> times{0, 1, 3, 3.5, 10, 11};
  const std::vector<double> values{1, -2, 4, 0, 3, 2};
  const double period = 4;
  const auto cost = [&](const SmoothingSpline& f) {
    double sum = 0, bend = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double weight = ((i > 0 ? times[i] - times[i - 1] : 0) +
                             (i + 1 < times.size() ? times[i + 1] - times[i] : 0)) /
                            2;
      sum += weight * std::pow(values[i] - f.value(times[i]), 2);
    }
    // Simpson's rule is exact for the square of the linear second derivative.
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      const double h = times[i + 1] - times[i], e = 1e-4 * h;
      const auto second = [&](double t) { return (f.rate(t + e) - f.rate(t - e)) / (2 * e); };
      const double a = second(times[i] + e), c = second(times[i + 1] - e), b = 0.5 * (a + c);
      bend += h / 6 * (a * a + 4 * b * b + c * c);
    }
    return sum + std::pow(period / (2 * pi), 4) * bend;
  };
  const SmoothingSpline best(times, values, period);
  for (std::size_t i = 0; i < times.size(); ++i)
    for (const double change : {-0.1, 0.1}) {
      std::vector<double> other;
      for (const double t : times)
        other.push_back(best.value(t));
      other[i] += change;
      EXPECT_GT(cost(SmoothingSpline(times, other, 0)), cost(best));
    }
}

// Fixes of a second with a metre of noise: what is left in place and speed is what the response
// says, sqrt(1.666 w / 2 pi) m and sqrt(0.5554 w^3 / 2 pi) m/s with w = 2 pi / 60 s.
TEST(SmoothingSpline, LeavesOfNoiseWhatTheResponseSays) {
  const auto times = evenly(20001, 1);
  std::mt19937 random(7);
  std::normal_distribution<double> metre(0, 1);
  const SmoothingSpline spline(times, sampled(times, [&](double) { return metre(random); }), 60);
  double place = 0, speed = 0, count = 0;
  for (double t = 100; t < 19900; t += 1, count += 1)
    place += std::pow(spline.value(t), 2), speed += std::pow(spline.rate(t), 2);
  const double w = 2 * pi / 60;
  EXPECT_NEAR(std::sqrt(place / count), std::sqrt(1.666 * w / (2 * pi)), 0.02);
  EXPECT_NEAR(std::sqrt(speed / count), std::sqrt(0.5554 * std::pow(w, 3) / (2 * pi)), 1e-3);
}

// The strongest that is allowed is still exact to a part in a thousand.
TEST(SmoothingSpline, RoundOffDoesNotShow) {
  const auto times = evenly(20001, 1);
  const SmoothingSpline spline(
      times, sampled(times, [](double t) { return std::sin(2 * pi * t / 2000); }), 2000);
  for (double t = 8000; t < 12000; t += 100)
    EXPECT_NEAR(spline.value(t), 0.5 * std::sin(2 * pi * t / 2000), 1e-3) << t;
}

TEST(SmoothingSpline, OfTwoRowsIsALine) {
  const SmoothingSpline spline({0, 2}, {1, 5}, 60);
  EXPECT_EQ(spline.value(1), 3);
  EXPECT_EQ(spline.rate(1), 2);
}

}  // namespace
}  // namespace hawser
