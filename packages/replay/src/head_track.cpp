#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/preparation.hpp"

namespace hawser {
namespace {

constexpr double gap_factor = 5;         // of the usual time between shots
constexpr double jump_factor = 5;        // of the usual way between shots
constexpr double share_of_noise = 0.02;  // of the mean speed, which smoothing leaves

/// Of fixes at these times: the scatter per direction that second differences show, m.
double scatter(const std::vector<double>& times, const std::vector<Place>& places) {
  std::vector<double> squares;
  for (std::size_t i = 2; i < places.size(); ++i) {
    const double h = times[i - 1] - times[i - 2], k = times[i] - times[i - 1];
    const double a = k / (h + k), b = h / (h + k);  // a y0 - y1 + b y2
    double sum = 0;
    for (std::size_t j = 0; j < 2; ++j)
      sum += std::pow(a * places[i - 2][j] - places[i - 1][j] + b * places[i][j], 2);
    squares.push_back(sum / (2 * (a * a + 1 + b * b)));
  }
  // The median of a sum of two squares is .693 of its mean; a turn or an outlier leaves it alone.
  return squares.empty() ? 0 : std::sqrt(median(squares) / 0.693);
}

class HeadTrack {
 public:
  HeadTrack(const NavigationLine& line, const LineOptions& options, MeasuredLine& result,
            Diagnostics& diagnostics)
      : line_(line), options_(options), result_(result), diagnostics_(diagnostics) {}

  void find() {
    if (line_.has_times() == options_.speed.has_value())
      return fault({line_.file, 0, 0},
                   line_.has_times() ? "the file has times; a speed would contradict them"
                                     : "the file has no times; --speed 2.3 would say that the "
                                       "head goes 2.3 m/s along its track");
    std::vector<std::size_t> shots;  // in which the head is known
    std::vector<double> clock;
    for (std::size_t s = 0; s < result_.places.size(); ++s)
      if (is_known(result_.places[s].front())) {
        shots.push_back(s);
        result_.head.push_back(result_.places[s].front());
        clock.push_back(line_.shots[s].time - line_.shots[0].time);
      }
    check_jumps(shots);
    if (!line_.has_times()) clock = ways();
    result_.head_noise = scatter(clock, result_.head);
    const double h = clock.back() / static_cast<double>(clock.size() - 1);
    const double mean = distance(result_.head.front(), result_.head.back()) / clock.back();
    result_.smooth = options_.smooth.value_or(std::cbrt(
        21.9 * h * std::pow(result_.head_noise / std::max(1e-9, share_of_noise * mean), 2)));
    if (!line_.has_times()) {  // by the way along the smoothed track, noise does not count as way
      clock = smoothed_ways(clock);
      for (double& time : clock)
        time /= *options_.speed;
    }
    if (!options_.smooth)
      result_.notes.push_back(
          fmt::format("fixes of the head scatter by {:.2g} m; its track is smoothed over {:.0f} s, "
                      "which leaves .02 of the speed; --smooth says otherwise",
                      result_.head_noise, result_.smooth));
    check_gaps(shots, clock);
    result_.head_times = clock;
    result_.east = spline(0, clock);
    result_.north = spline(1, clock);
    for (std::size_t s = 0; s <= shots.back(); ++s)
      result_.times.push_back(line_.has_times() ? line_.shots[s].time - line_.shots[0].time
                                                : time_between(shots, clock, s));
    if (shots.back() + 1 < result_.places.size())
      result_.notes.push_back(fmt::format("the last {} shots are left out: their head is missing",
                                          result_.places.size() - shots.back() - 1));
    result_.places.resize(result_.times.size());
    result_.speed = smoothed_ways(clock).back() / clock.back();
  }

 private:
  void fault(const Location& where, const std::string& sentence) {
    diagnostics_.error(where, sentence);
  }

  /// A shot without a head lies between its neighbours as its number does.
  double time_between(const std::vector<std::size_t>& shots, const std::vector<double>& clock,
                      std::size_t s) const {
    const auto above = std::lower_bound(shots.begin(), shots.end(), s);
    const auto i = static_cast<std::size_t>(above - shots.begin());
    if (*above == s) return clock[i];
    const double share =
        static_cast<double>(s - shots[i - 1]) / static_cast<double>(shots[i] - shots[i - 1]);
    return clock[i - 1] + share * (clock[i] - clock[i - 1]);
  }

  std::shared_ptr<const SmoothingSpline> spline(std::size_t axis,
                                                const std::vector<double>& clock) const {
    std::vector<double> values;
    for (const Place& place : result_.head)
      values.push_back(place[axis]);
    return std::make_shared<SmoothingSpline>(clock, values, result_.smooth);
  }

  /// s at the given speed, along the straight lines between the fixes.
  std::vector<double> ways() const {
    std::vector<double> along = {0};
    for (std::size_t i = 1; i < result_.head.size(); ++i)
      along.push_back(along.back() +
                      distance(result_.head[i - 1], result_.head[i]) / *options_.speed);
    return along;
  }

  /// m along the smoothed track, per fix.
  std::vector<double> smoothed_ways(const std::vector<double>& clock) const {
    constexpr int pieces = 8;
    const auto east = spline(0, clock), north = spline(1, clock);
    std::vector<double> along = {0};
    for (std::size_t i = 1; i < clock.size(); ++i) {
      double way = 0;
      for (int p = 0; p < pieces; ++p) {
        const auto at = [&](int k) {
          return clock[i - 1] + (clock[i] - clock[i - 1]) * k / pieces;
        };
        way += std::hypot(east->value(at(p + 1)) - east->value(at(p)),
                          north->value(at(p + 1)) - north->value(at(p)));
      }
      along.push_back(along.back() + way);
    }
    return along;
  }

  void check_jumps(const std::vector<std::size_t>& shots) {
    if (shots.size() < 4)
      return fault({line_.file, 0, 0}, "the head is known at fewer than four shots");
    std::vector<double> ways;
    const auto way = [&](std::size_t i) {
      return distance(result_.head[i - 1], result_.head[i]) /
             static_cast<double>(shots[i] - shots[i - 1]);
    };
    for (std::size_t i = 1; i < shots.size(); ++i)
      ways.push_back(way(i));
    const double usual = median(ways);
    int told = 0;
    for (std::size_t i = 1; i < shots.size() && told < 3; ++i)
      if (way(i) > jump_factor * usual) {
        ++told;
        fault(line_.shots[shots[i]].where,
              fmt::format(
                  "the head is {:.5g} m from where it was at the shot before, and {:.4g} m are "
                  "usual (median)",
                  way(i), usual));
      }
  }

  void check_gaps(const std::vector<std::size_t>& shots, const std::vector<double>& clock) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < clock.size(); ++i)
      steps.push_back(clock[i] - clock[i - 1]);
    const double usual = median(steps);
    const double most = std::max(gap_factor * usual, options_.longest_gap.value_or(0));
    for (std::size_t i = 1; i < clock.size(); ++i)
      if (steps[i - 1] > most)
        fault(line_.shots[shots[i]].where,
              fmt::format(
                  "the head is not known for {:.5g} s before this shot, and {:.4g} s are usual "
                  "(median); --longest-gap {:.0f} would bridge it by the smoothed track",
                  steps[i - 1], usual, std::ceil(steps[i - 1])));
  }

  const NavigationLine& line_;
  const LineOptions& options_;
  MeasuredLine& result_;
  Diagnostics& diagnostics_;
};

}  // namespace

void find_track(const NavigationLine& line, const LineOptions& options, MeasuredLine& result,
                Diagnostics& diagnostics) {
  HeadTrack(line, options, result, diagnostics).find();
}

}  // namespace hawser
