#pragma once
// Positions of a model against those that were measured, and the yardstick of both: a cable every
// point of which follows the head's path through the water.
#include "hawser/replay/measured_line.hpp"

namespace hawser {

/// [shot][receiver], m from the line's origin.
using Positions = std::vector<std::vector<Place>>;

/// Every receiver where the head was, or the cable lay at first, its arc length ago along the path;
/// in still water.
Positions follow_the_path(const MeasuredLine& line);

struct Comparison {
  double rms = 0;                     ///< m, of the distances at all shots and receivers
  std::vector<double> rms_of_shot{};  ///< m; NaN where nothing was measured
  std::vector<double> tail_error{};   ///< m, distance at the last receiver; NaN where it is missing
  double tail_rms = 0;                ///< m
  double median = 0, greatest = 0;    ///< m, of the distances
  std::size_t count = 0;              ///< of places
};

Comparison compare(const MeasuredLine& line, const Positions& model);

}  // namespace hawser
