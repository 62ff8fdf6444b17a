#include "src/oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hawser {
namespace {

struct Samples {
  const std::vector<double>& times;
  const std::vector<double>& values;
};

/// A rise through a level, between the samples `before` and `before` + 1.
struct Rise {
  double time;
  std::size_t before;
};

struct Band {
  double middle, amplitude;
};

Band band_of(const Samples& samples, std::size_t begin, std::size_t end) {
  const auto first = samples.values.begin();
  const auto [least, greatest] = std::minmax_element(first + static_cast<std::ptrdiff_t>(begin),
                                                     first + static_cast<std::ptrdiff_t>(end));
  return {(*greatest + *least) / 2, (*greatest - *least) / 2};
}

std::vector<Rise> rises_through(const Samples& samples, const Band& band) {
  const double low = band.middle - band.amplitude / 4, high = band.middle + band.amplitude / 4;
  std::vector<Rise> rises;
  bool came_from_below = false, crossed = false;
  Rise candidate{};
  for (std::size_t i = 0; i + 1 < samples.values.size(); ++i) {
    const double now = samples.values[i], next = samples.values[i + 1];
    if (now < low) came_from_below = true, crossed = false;
    if (came_from_below && now <= band.middle && next > band.middle) {
      const double share = (band.middle - now) / (next - now);
      candidate = {samples.times[i] + share * (samples.times[i + 1] - samples.times[i]), i};
      crossed = true;
    }
    if (crossed && next >= high) {
      rises.push_back(candidate);
      came_from_below = crossed = false;
    }
  }
  return rises;
}

/// Value at the summit of the parabola through the samples i - 1, i and i + 1, of which the middle
/// one is the greatest or the least.
double summit(const Samples& samples, std::size_t i) {
  const double value = samples.values[i];
  if (i == 0 || i + 1 == samples.values.size()) return value;
  const double before = samples.times[i - 1] - samples.times[i],
               after = samples.times[i + 1] - samples.times[i];
  const double slope_before = (samples.values[i - 1] - value) / before,
               slope_after = (samples.values[i + 1] - value) / after;
  const double curvature = (slope_after - slope_before) / (after - before);
  if (curvature == 0) return value;
  const double slope = slope_before - curvature * before;
  return value - slope * slope / (4 * curvature);
}

struct Period {
  double length, average;
  Band band;
};

Period period_between(const Samples& samples, const Rise& first, const Rise& second, double level) {
  std::size_t least = first.before + 1, greatest = least;
  double integral = 0, time = first.time, value = level;
  const auto add = [&](double next_time, double next_value) {
    integral += (next_time - time) * (value + next_value) / 2;
    time = next_time, value = next_value;
  };
  for (std::size_t i = first.before + 1; i <= second.before; ++i) {
    if (samples.values[i] < samples.values[least]) least = i;
    if (samples.values[i] > samples.values[greatest]) greatest = i;
    add(samples.times[i], samples.values[i]);
  }
  add(second.time, level);
  const double length = second.time - first.time;
  const double low = summit(samples, least), high = summit(samples, greatest);
  return {length, integral / length, {(high + low) / 2, (high - low) / 2}};
}

}  // namespace

Oscillation find_oscillation(const std::vector<double>& times, const std::vector<double>& values,
                             int periods) {
  Oscillation result;
  if (values.size() < 3) return result;
  const Samples samples{times, values};
  // What came before the periods must not decide where their middle is: first the later half says
  // it, then the periods themselves.
  std::size_t begin = values.size() / 2;
  std::vector<Rise> rises;
  Band band{};
  constexpr int rounds = 4;
  for (int round = 0; round < rounds; ++round) {
    band = band_of(samples, begin, values.size());
    rises = rises_through(samples, band);
    if (rises.size() < 2) return result;
    const auto wanted = static_cast<std::size_t>(periods) + 1;
    if (rises.size() > wanted)
      rises.erase(rises.begin(), rises.end() - static_cast<std::ptrdiff_t>(wanted));
    if (rises.front().before + 1 == begin) break;
    begin = rises.front().before + 1;
  }

  std::vector<Period> found;
  for (std::size_t i = 0; i + 1 < rises.size(); ++i)
    found.push_back(period_between(samples, rises[i], rises[i + 1], band.middle));
  const auto count = static_cast<double>(found.size());
  result.periods = static_cast<int>(found.size());
  result.from = rises.front().time;
  result.to = rises.back().time;
  result.frequency = count / (result.to - result.from);
  for (const Period& period : found) {
    result.average += period.average * period.length / (result.to - result.from);
    result.middle += period.band.middle / count;
    result.amplitude += period.band.amplitude / count;
  }
  for (const Period& period : found) {
    result.amplitude_scatter =
        std::max(result.amplitude_scatter, std::abs(period.band.amplitude / result.amplitude - 1));
    result.frequency_scatter =
        std::max(result.frequency_scatter, std::abs(1 / (period.length * result.frequency) - 1));
  }
  return result;
}

}  // namespace hawser
