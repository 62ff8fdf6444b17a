#include "hawser/replay/measured_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/preparation.hpp"

namespace hawser {
namespace {

constexpr double spacing_slack = 0.1;  // between what is said and what is measured

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
    result_.frame = line_.header;
    for (const Shot& shot : line_.shots)
      result_.places.push_back(shot.places);
    find_head();
    check_first_shot();
    if (ok()) find_arc_lengths();
    if (ok()) find_track(line_, options_, result_, diagnostics_);
    if (ok()) find_shape(options_, result_);
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

  const NavigationLine& line_;
  const LineOptions& options_;
  Diagnostics& diagnostics_;
  MeasuredLine result_;
  bool is_reversed_ = false;
};

}  // namespace

double distance(const Place& a, const Place& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

double median(std::vector<double> values) {
  if (values.empty()) return no_value;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Place MeasuredLine::head_at(double time) const { return {east->value(time), north->value(time)}; }

MeasuredLine prepare_line(const NavigationLine& line, const LineOptions& options,
                          Diagnostics& diagnostics) {
  return Preparation(line, options, diagnostics).prepare();
}

}  // namespace hawser
