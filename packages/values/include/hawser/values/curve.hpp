#pragma once
// A curve as a CSV file: the places along it in order, such as a cable's measured shape.
//
//   x_m,y_m            arc_length_m,x_m,y_m,z_m
//   0,0                0,0,0,-8
//   -60,-80        100,-60,-80,-8
#include <array>
#include <string>
#include <vector>

#include "hawser/deck/diagnostics.hpp"

namespace hawser {

struct Curve {
  int dimension = 2;                          ///< 3 with a column z_m
  std::vector<std::array<double, 3>> points;  ///< m
  std::vector<double> arc_lengths;            ///< m, from the first point; empty: not said
  double length() const;                      ///< m, of the chords
};

/// Faults go to `diagnostics`, after which the curve is not to be used: those of columns; fewer
/// than two places, the same place twice, arc lengths that do not begin at 0 or do not grow, or
/// chords longer than them by more than a tenth.
Curve read_curve(const std::string& text, const std::string& file, Diagnostics& diagnostics);

}  // namespace hawser
