#include "src/oscillation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace hawser {
namespace {

struct Series {
  std::vector<double> times, values;
};

Series sampled(double step, double end, const std::function<double(double)>& of) {
  Series series;
  for (int i = 0; i * step <= end; ++i) {
    series.times.push_back(i * step);
    series.values.push_back(of(i * step));
  }
  return series;
}

double wave(double t) { return 3 + 2 * std::cos(2 * M_PI * 1.3 * t + 0.4); }

TEST(Oscillation, OfACosineIsKnown) {
  const Series series = sampled(0.02, 20, wave);  // 38 samples a period
  const Oscillation found = find_oscillation(series.times, series.values, 5);
  EXPECT_EQ(found.periods, 5);
  EXPECT_NEAR(found.frequency, 1.3, 1e-4);
  EXPECT_NEAR(found.middle, 3, 1e-5);
  EXPECT_NEAR(found.average, 3, 1e-3);
  EXPECT_NEAR(found.amplitude, 2, 1e-4);
  EXPECT_LT(found.amplitude_scatter, 1e-4);
  EXPECT_NEAR(found.to - found.from, 5 / 1.3, 1e-3);
  EXPECT_GT(found.to, 19);
}

TEST(Oscillation, WhatCameBeforeDoesNotCount) {
  const Series series = sampled(0.02, 20, [](double t) { return wave(t) + 50 * std::exp(-t); });
  const Oscillation found = find_oscillation(series.times, series.values, 5);
  EXPECT_EQ(found.periods, 5);
  EXPECT_NEAR(found.middle, 3, 1e-4);
  EXPECT_NEAR(found.amplitude, 2, 1e-4);
}

TEST(Oscillation, ARippleMakesNoPeriod) {
  const Series series =
      sampled(0.005, 20, [](double t) { return wave(t) + 0.3 * std::cos(2 * M_PI * 9.4 * t); });
  const Oscillation found = find_oscillation(series.times, series.values, 10);
  EXPECT_EQ(found.periods, 10);
  EXPECT_NEAR(found.frequency, 1.3, 0.02);
  EXPECT_GT(found.amplitude_scatter, 1e-3);
}

TEST(Oscillation, AGrowingOneScatters) {
  const Series series =
      sampled(0.01, 20, [](double t) { return std::exp(t / 10) * std::sin(2 * M_PI * t); });
  const Oscillation found = find_oscillation(series.times, series.values, 3);
  EXPECT_EQ(found.periods, 3);
  EXPECT_NEAR(found.amplitude_scatter, 0.1, 0.02);  // exp(1/10) from one period to the next
}

TEST(Oscillation, TakesTheWholePeriodsThatThereAre) {
  const Series series = sampled(0.02, 3, wave);
  EXPECT_EQ(find_oscillation(series.times, series.values, 10).periods, 3);
  EXPECT_EQ(
      find_oscillation(series.times, std::vector<double>(series.times.size(), 1.0), 10).periods, 0);
  EXPECT_EQ(find_oscillation({}, {}, 10).periods, 0);
}

TEST(Oscillation, StepsMayDiffer) {
  Series series;
  for (double t = 0; t < 10; t += 0.02 + 0.01 * std::sin(t)) {
    series.times.push_back(t);
    series.values.push_back(wave(t));
  }
  const Oscillation found = find_oscillation(series.times, series.values, 5);
  EXPECT_NEAR(found.frequency, 1.3, 1e-3);
  EXPECT_NEAR(found.amplitude, 2, 1e-3);
}

}  // namespace
}  // namespace hawser
