#pragma once
// From errors on levels, each of half the size, to an order of accuracy.
#include <optional>
#include <vector>

namespace hawser {

struct ObservedOrder {
  std::vector<double> pairs;  ///< log2(e_l / e_(l+1)) of neighbouring levels, coarse to fine
  double fitted = 0;          ///< least squares over all levels, log e against log h
  std::optional<double> standard_error;  ///< of the fitted one; three levels are needed
};

/// At least two errors, coarse to fine. Not finite where an error is not above zero.
ObservedOrder observed_order(const std::vector<double>& errors);

}  // namespace hawser
