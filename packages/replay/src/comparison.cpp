#include "hawser/replay/comparison.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {

Comparison compare(const MeasuredLine& line, const Positions& model) {
  Comparison result;
  std::vector<double> distances;
  double sum = 0, tail_sum = 0;
  int tails = 0;
  for (std::size_t s = 0; s < line.places.size(); ++s) {
    const auto& measured = line.places[s];
    double of_shot = 0;
    int count = 0;
    result.tail_error.push_back(no_value);
    for (std::size_t r = 0; r < measured.size(); ++r) {
      if (!is_known(measured[r])) continue;
      const double off =
          std::hypot(model[s][r][0] - measured[r][0], model[s][r][1] - measured[r][1]);
      of_shot += off * off;
      ++count;
      distances.push_back(off);
      if (r + 1 < measured.size()) continue;
      result.tail_error.back() = off;
      tail_sum += off * off;
      ++tails;
    }
    sum += of_shot;
    result.rms_of_shot.push_back(count == 0 ? no_value : std::sqrt(of_shot / count));
  }
  result.count = distances.size();
  result.rms = std::sqrt(sum / static_cast<double>(result.count));
  result.tail_rms = tails == 0 ? no_value : std::sqrt(tail_sum / tails);
  std::sort(distances.begin(), distances.end());
  result.median = distances[distances.size() / 2];
  result.greatest = distances.back();
  return result;
}

}  // namespace hawser
