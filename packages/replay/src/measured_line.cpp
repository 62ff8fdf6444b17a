#include "hawser/replay/measured_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/base/constants.hpp"

namespace hawser {
namespace {

constexpr double gap_factor = 5;         // of the usual time between shots
constexpr double jump_factor = 5;        // of the usual way between shots
constexpr double spacing_slack = 0.1;    // between what is said and what is measured
constexpr double share_of_noise = 0.02;  // of the mean speed, which smoothing leaves
constexpr double shape_periods = 6;      // of the shape's smoothing, in distances of receivers

double distance(const Place& a, const Place& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

double median(std::vector<double> values) {
  if (values.empty()) return no_value;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

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

class Preparation {
 public:
  Preparation(const NavigationLine& line, const LineOptions& options, Diagnostics& diagnostics)
      : line_(line), options_(options), diagnostics_(diagnostics) {}

  MeasuredLine prepare() {
    const std::size_t before = diagnostics_.error_count();
    const auto ok = [&] { return diagnostics_.error_count() == before; };
    result_.file = line_.file;
    result_.format = line_.format;
    result_.receivers = line_.receivers;
    for (const Shot& shot : line_.shots)
      result_.places.push_back(shot.places);
    find_head();
    check_first_shot();
    if (ok()) find_arc_lengths();
    if (ok()) find_times();
    if (ok()) find_shape();
    for (const Shot& shot : line_.shots)
      if (result_.shot_numbers.size() < result_.times.size())
        result_.shot_numbers.push_back(shot.number);
    return std::move(result_);
  }

 private:
  void fault(const Location& where, const std::string& sentence) {
    diagnostics_.error(where, sentence);
  }

  /// The end that goes first is the head: there the way of the cable points where it is going.
  void find_head() {
    double along = 0;
    const auto& places = result_.places;
    for (std::size_t s = 1; s < places.size(); ++s)
      for (std::size_t r = 1; r < line_.receivers.size(); ++r) {
        const Place &a = places[s][r - 1], &b = places[s][r], &was = places[s - 1][r];
        if (!is_known(a) || !is_known(b) || !is_known(was)) continue;
        along += (a[0] - b[0]) * (b[0] - was[0]) + (a[1] - b[1]) * (b[1] - was[1]);
      }
    if (along >= 0) return;
    std::reverse(result_.receivers.begin(), result_.receivers.end());
    for (auto& shot : result_.places)
      std::reverse(shot.begin(), shot.end());
    is_reversed_ = true;
    result_.notes.push_back("receivers count from the tail: the head is receiver " +
                            std::to_string(result_.receivers.front()));
  }

  void check_first_shot() {
    const Shot& first = line_.shots.front();
    const auto& places = result_.places.front();
    const auto known = std::count_if(places.begin(), places.end(), is_known);
    if (!is_known(places.front()) || !is_known(places.back()))
      fault(first.where, fmt::format("receiver {}, the {} of the cable, is missing in shot {}, at "
                                     "which the run would begin",
                                     is_known(places.front()) ? result_.receivers.back()
                                                              : result_.receivers.front(),
                                     is_known(places.front()) ? "tail" : "head", first.number));
    else if (2 * static_cast<std::size_t>(known) < places.size())
      fault(first.where,
            fmt::format("shot {}, at which the run would begin, has {} of {} receivers: "
                        "the cable's shape is not known",
                        first.number, known, places.size()));
    result_.origin = places.front();
    for (auto& shot : result_.places)
      for (Place& place : shot)
        for (std::size_t j = 0; j < 2; ++j)
          place[j] -= result_.origin[j];
  }

  /// Distances of neighbours per step of their numbers, or per metre of arc length if it is given.
  double measured_spacing(const std::vector<double>& along) const {
    std::vector<double> chords;
    for (const auto& shot : result_.places)
      for (std::size_t r = 1; r < shot.size(); ++r)
        if (is_known(shot[r - 1]) && is_known(shot[r]))
          chords.push_back(distance(shot[r - 1], shot[r]) / std::abs(along[r] - along[r - 1]));
    return median(chords);
  }

  void find_arc_lengths() {
    std::vector<double> numbers(result_.receivers.begin(), result_.receivers.end());
    if (!line_.arc_lengths.empty()) {
      numbers = line_.arc_lengths;
      if (is_reversed_) std::reverse(numbers.begin(), numbers.end());
      for (std::size_t r = 1; r < numbers.size(); ++r)
        if (!((numbers[r] > numbers[r - 1]) == (numbers[1] > numbers[0])) ||
            numbers[r] == numbers[r - 1])
          return fault({line_.file, 0, 0},
                       fmt::format("the arc lengths of receivers {} and {} are "
                                   "not in the order of their numbers",
                                   result_.receivers[r - 1], result_.receivers[r]));
    }
    const double found = measured_spacing(numbers);
    if (std::isnan(found) || found == 0)
      return fault({line_.file, 0, 0}, "no two neighbouring receivers are known at any shot");
    const bool is_said = !line_.arc_lengths.empty() || options_.spacing;
    const double said = !line_.arc_lengths.empty() ? 1 : options_.spacing.value_or(found);
    if (std::abs(found / said - 1) > spacing_slack)
      return fault(
          {line_.file, 0, 0},
          line_.arc_lengths.empty()
              ? fmt::format("receivers of successive numbers are {:.4g} m apart (median), and "
                            "the spacing is said to be {:g} m; are shot and receiver mixed up?",
                            found, said)
              : fmt::format("receivers are {:.4g} times as far apart (median) as their arc "
                            "lengths say",
                            found));
    if (!is_said)
      result_.notes.push_back(fmt::format(
          "receivers of successive numbers are {:.5g} m apart (median); --spacing says it exactly",
          found));
    for (const double number : numbers)
      result_.arc_lengths.push_back(said * std::abs(number - numbers.front()));
  }

  void find_times() {
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

  void find_shape() {
    std::vector<double> along, east, north;
    const auto& places = result_.places.front();
    for (std::size_t r = 0; r < places.size(); ++r)
      if (is_known(places[r])) {
        along.push_back(result_.arc_lengths[r]);
        east.push_back(places[r][0]);
        north.push_back(places[r][1]);
      }
    result_.shape_smooth = options_.shape_smooth.value_or(shape_periods * result_.length() /
                                                          static_cast<double>(along.size() - 1));
    const SmoothingSpline x(along, east, result_.shape_smooth),
        y(along, north, result_.shape_smooth);
    // The head goes where its track begins; what that moves it by fades along the cable.
    const Place begin = head_at(0);
    const int points = 8 * static_cast<int>(along.size());
    const double length = result_.length();
    for (int i = 0; i <= points; ++i) {
      const double share = static_cast<double>(i) / points, s = share * length;
      result_.shape.push_back({x.value(s) + (1 - share) * (begin[0] - x.value(0)),
                               y.value(s) + (1 - share) * (begin[1] - y.value(0)), 0});
    }
    fit_length(length);
  }

  /// As long as the cable and a little more: cut, or straight on at the tail.
  void fit_length(double length) {
    constexpr double more = 1.02;
    auto& shape = result_.shape;
    double along = 0;
    for (std::size_t i = 1; i < shape.size(); ++i) {
      along += std::hypot(shape[i][0] - shape[i - 1][0], shape[i][1] - shape[i - 1][1]);
      if (along > more * length) shape.resize(i + 1);
    }
    if (along >= more * length) return;
    const auto &last = shape.back(), &before = shape[shape.size() - 2];
    const double step = std::hypot(last[0] - before[0], last[1] - before[1]);
    const double share = (more * length - along) / step;
    shape.push_back(
        {last[0] + share * (last[0] - before[0]), last[1] + share * (last[1] - before[1]), 0});
  }

  Place head_at(double time) const {
    return {result_.east->value(time), result_.north->value(time)};
  }

  const NavigationLine& line_;
  const LineOptions& options_;
  Diagnostics& diagnostics_;
  MeasuredLine result_;
  bool is_reversed_ = false;
};

}  // namespace

Place MeasuredLine::head_at(double time) const { return {east->value(time), north->value(time)}; }

MeasuredLine prepare_line(const NavigationLine& line, const LineOptions& options,
                          Diagnostics& diagnostics) {
  return Preparation(line, options, diagnostics).prepare();
}

}  // namespace hawser
