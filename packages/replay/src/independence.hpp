#pragma once
// How many of the numbers that a fit leaves off say something of their own.
#include "hawser/replay/comparison.hpp"

namespace hawser {

/// Numbers that count as independent, of those that there are: as many as the residuals'
/// correlations along the line and along the cable leave.
double independent_count(const MeasuredLine& line, const Positions& model, std::size_t numbers);

}  // namespace hawser
