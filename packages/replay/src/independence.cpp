#include "src/independence.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

/// How many neighbours in a row say the same thing: 1 + 2 (sum of the correlations until they end),
/// of series residual(series, place), NaN where there is none.
template <class Residual>
double correlation_length(std::size_t series, std::size_t places, const Residual& residual) {
  double variance = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < series; ++i)
    for (std::size_t p = 0; p < places; ++p)
      if (const double r = residual(i, p); !std::isnan(r)) {
        variance += r * r;
        ++count;
      }
  if (count == 0 || variance == 0) return 1;
  variance /= static_cast<double>(count);
  double length = 1;
  for (std::size_t lag = 1; lag < places; ++lag) {
    double sum = 0;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < series; ++i)
      for (std::size_t p = 0; p + lag < places; ++p) {
        const double product = residual(i, p) * residual(i, p + lag);
        if (std::isnan(product)) continue;
        sum += product;
        ++pairs;
      }
    const double correlation = pairs == 0 ? 0 : sum / static_cast<double>(pairs) / variance;
    if (correlation <= 0) break;
    length += 2 * correlation * (1 - static_cast<double>(lag) / static_cast<double>(places));
  }
  return length;
}

}  // namespace

double independent_count(const MeasuredLine& line, const Positions& model, std::size_t numbers) {
  const std::size_t shots = line.places.size(), receivers = line.receivers.size();
  const auto residual = [&](std::size_t s, std::size_t r, std::size_t j) {
    return line.places[s][r][j] - model[s][r][j];
  };
  const double along_line =
      correlation_length(2 * receivers, shots,
                         [&](std::size_t i, std::size_t s) { return residual(s, i / 2, i % 2); });
  const double along_cable =
      correlation_length(2 * shots, receivers,
                         [&](std::size_t i, std::size_t r) { return residual(i / 2, r, i % 2); });
  return std::max(1.0, static_cast<double>(numbers) / (along_line * along_cable));
}

}  // namespace hawser
