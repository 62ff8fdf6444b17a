#include "hawser/report/observed_order.hpp"

#include <cmath>

namespace hawser {

ObservedOrder observed_order(const std::vector<double>& errors) {
  ObservedOrder result;
  const auto count = static_cast<double>(errors.size());
  const double middle = 0.5 * (count - 1);  // of the levels, which are -log2 h
  double mean = 0, spread = 0, product = 0;
  for (const double error : errors)
    mean += std::log2(error) / count;
  for (std::size_t level = 0; level < errors.size(); ++level) {
    const double x = static_cast<double>(level) - middle;
    spread += x * x;
    product += x * (std::log2(errors[level]) - mean);
    if (level > 0) result.pairs.push_back(std::log2(errors[level - 1] / errors[level]));
  }
  result.fitted = -product / spread;
  if (errors.size() < 3) return result;
  double squares = 0;
  for (std::size_t level = 0; level < errors.size(); ++level) {
    const double x = static_cast<double>(level) - middle;
    const double off = std::log2(errors[level]) - mean + result.fitted * x;
    squares += off * off;
  }
  result.standard_error = std::sqrt(squares / (count - 2) / spread);
  return result;
}

}  // namespace hawser
