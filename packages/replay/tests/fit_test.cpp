// The fit against models whose answer is known.
#include "hawser/replay/fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "lines.hpp"

namespace hawser {
namespace {

MeasuredLine line_of(int shots, int receivers) {
  Diagnostics diagnostics;
  LineOptions options;
  options.speed = 2.5;
  return prepare_line(straight_line(shots, receivers), options, diagnostics);
}

/// Both directions of a place are moved by parameters as they say.
Positions moved(const MeasuredLine& line, const std::function<Place(double arc, double time)>& by) {
  Positions positions = line.places;
  for (std::size_t s = 0; s < positions.size(); ++s)
    for (std::size_t r = 0; r < positions[s].size(); ++r) {
      const Place way = by(line.arc_lengths[r], line.times[s]);
      positions[s][r][0] += way[0];
      positions[s][r][1] += way[1];
    }
  return positions;
}

std::vector<ReplayParameter> two_parameters() {
  return {{"a", "1", "", "0", true, 0.1, -100, 100}, {"b", "m/s", "", "0", true, 0.1, -100, 100}};
}

TEST(Fit, FindsTheParametersOfACurvedModel) {
  const MeasuredLine plain = line_of(20, 21);
  const ReplayModel model = [&](const std::vector<double>& v) {
    return moved(plain, [&](double arc, double time) {
      return Place{v[0] * v[0] * arc / 100, v[1] * time};
    });
  };
  MeasuredLine measured = plain;
  measured.places = model({1.7, -0.3});
  int told = 0;
  const FitResult found = fit_parameters(measured, two_parameters(), {1, 0}, model,
                                         [&](const FitIteration&) { ++told; });
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.values[0], 1.7, 1e-4);
  EXPECT_NEAR(found.values[1], -0.3, 1e-4);
  EXPECT_GT(told, 2);
  EXPECT_LT(std::abs(found.correlations[0][1]), 1e-6);  // east and north
}

// White noise is as many measurements as there are numbers: the spread of what is found over many
// lines is the error that each tells.
TEST(Fit, ItsErrorIsTheSpreadUnderWhiteNoise) {
  const MeasuredLine plain = line_of(20, 21);
  const ReplayModel model = [&](const std::vector<double>& v) {
    return moved(plain, [&](double arc, double time) {
      return Place{v[0] * arc / 1000, v[0] * time / 200 + v[1] * arc / 1000};
    });
  };
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 5);
  const int lines = 200;
  double squares = 0, told = 0;
  for (int i = 0; i < lines; ++i) {
    MeasuredLine measured = plain;
    measured.places = moved(plain, [&](double, double) {
      return Place{noise(random), noise(random)};
    });
    const FitResult found =
        fit_parameters(measured, two_parameters(), {0, 0}, model, [](const FitIteration&) {});
    squares += found.values[0] * found.values[0] / lines;
    told += found.standard_errors[0] / lines;
  }
  EXPECT_NEAR(told / std::sqrt(squares), 1, 0.25);  // the count of independent ones is an estimate
}

// An error that the whole cable shares counts once per shot, not once per receiver.
TEST(Fit, ErrorsThatReceiversShareCountOnce) {
  const MeasuredLine plain = line_of(60, 21);
  const ReplayModel model = [&](const std::vector<double>& v) {
    return moved(plain, [&](double, double) { return Place{v[0], v[1]}; });
  };
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 5);
  MeasuredLine measured = plain;
  for (auto& shot : measured.places) {
    const Place off = {noise(random), noise(random)};
    for (Place& place : shot)
      place = {place[0] + off[0], place[1] + off[1]};
  }
  const FitResult found =
      fit_parameters(measured, two_parameters(), {0, 0}, model, [](const FitIteration&) {});
  EXPECT_NEAR(found.standard_errors[0], 5 / std::sqrt(60), 0.4);
}

TEST(Fit, StaysWithinBoundsAndSaysSo) {
  const MeasuredLine plain = line_of(20, 21);
  const ReplayModel model = [&](const std::vector<double>& v) {
    return moved(plain, [&](double arc, double) { return Place{v[0] * arc / 100, 0}; });
  };
  MeasuredLine measured = plain;
  measured.places = model({-2});
  std::vector<ReplayParameter> one = {two_parameters()[0]};
  one[0].least = 0;
  const FitResult found = fit_parameters(measured, one, {1}, model, [](const FitIteration&) {});
  EXPECT_EQ(found.values[0], 0);
  EXPECT_TRUE(found.at_bound[0]);
}

TEST(Fit, SaysWhatCannotBeToldApart) {
  const MeasuredLine plain = line_of(20, 21);
  const ReplayModel model = [&](const std::vector<double>& v) {
    return moved(plain, [&](double arc, double) {
      return Place{(v[0] + 0.5 * v[1]) * arc / 100, 1e-3 * v[1] * arc / 100};
    });
  };
  const auto both = two_parameters();
  const std::vector<ReplayParameter> one = {both[0]};
  MeasuredLine measured = plain;
  measured.places = model({3, 1});
  const ReplayModel alone = [&](const std::vector<double>& v) { return model({v[0], 0}); };
  const FitResult found = fit_parameters(measured, one, {1}, alone, [](const FitIteration&) {});
  const auto cosines = likeness(measured, found.positions, both, {found.values[0], 0}, model);
  EXPECT_NEAR(cosines[0][1], 1, 1e-5);
  EXPECT_THAT(
      what_cannot_be_told(one, found, both, cosines),
      testing::Contains(testing::HasSubstr("b was held, and moves the receivers as a does")));
}

}  // namespace
}  // namespace hawser
