#include "hawser/navigation/navigation_line.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "src/formats.hpp"
#include "src/line_builder.hpp"

namespace hawser {

bool NavigationLine::has_times() const { return !shots.empty() && !std::isnan(shots[0].time); }

void LineBuilder::shot(int number, double time, const Location& where) {
  const auto [known, is_new] = shots_.emplace(number, line_.shots.size());
  if (!is_new)
    diagnostics_.error(where,
                       "shot " + std::to_string(number) + " was there already, " +
                           line_.shots[known->second].where.text() +
                           "; what belongs to one shot stands together (are the columns shot and "
                           "receiver mixed up?)");
  line_.shots.push_back({number, where, time});
  positions_.emplace_back();
}

void LineBuilder::receiver(int number, const Place& place, double depth, const Location& where) {
  if (!positions_.back().emplace(number, Position{place, depth}).second)
    diagnostics_.error(where, "receiver " + std::to_string(number) + " of shot " +
                                  std::to_string(line_.shots.back().number) + " is given twice");
}

NavigationLine LineBuilder::finish() {
  if (line_.shots.size() < 2) {
    diagnostics_.error({line_.file, 0, 0},
                       "a line needs two shots at least, and there " +
                           std::string(line_.shots.empty() ? "are none" : "is one"));
    return std::move(line_);
  }
  std::set<int> numbers;
  bool has_depths = false;
  for (const auto& shot : positions_)
    for (const auto& [number, position] : shot) {
      numbers.insert(number);
      has_depths = has_depths || !std::isnan(position.depth);
    }
  if (numbers.size() < 2)
    diagnostics_.error({line_.file, 0, 0}, "a cable needs two receivers at least");
  line_.receivers.assign(numbers.begin(), numbers.end());
  const bool timed = line_.has_times();
  for (std::size_t s = 0; s < line_.shots.size(); ++s) {
    Shot& shot = line_.shots[s];
    for (const int number : line_.receivers) {
      const auto found = positions_[s].find(number);
      const bool known = found != positions_[s].end();
      shot.places.push_back(known ? found->second.place : Place{no_value, no_value});
      if (has_depths) shot.depths.push_back(known ? found->second.depth : no_value);
    }
    if (std::isnan(shot.time) == timed)
      diagnostics_.error(shot.where, "shot " + std::to_string(shot.number) + " has " +
                                         (timed ? "no time, and others have one"
                                                : "a time, and others have none"));
    else if (timed && s > 0 && !(shot.time > line_.shots[s - 1].time))
      diagnostics_.error(shot.where, "the time of shot " + std::to_string(shot.number) +
                                         " is not after that of shot " +
                                         std::to_string(line_.shots[s - 1].number));
    if (diagnostics_.error_count() >= 5) break;
  }
  return std::move(line_);
}

NavigationLine read_navigation(const std::string& text, const std::string& file,
                               const NavigationOptions& options, Diagnostics& diagnostics) {
  if (is_p190(text)) return read_p190(text, file, options, diagnostics);
  return read_csv_line(text, file, diagnostics);
}

}  // namespace hawser
