#pragma once
// Synthetic lines.
#include <cmath>
#include <string>

#include "hawser/replay/measured_line.hpp"

namespace hawser {

/// A straight cable of `receivers` 100 m apart that is towed east by 50 m per shot.
inline NavigationLine straight_line(int shots, int receivers) {
  NavigationLine line;
  line.file = "line.csv";
  line.format = "CSV";
  for (int r = 0; r < receivers; ++r)
    line.receivers.push_back(8 * r);
  for (int s = 0; s < shots; ++s) {
    Shot shot{100 + s, {"line.csv", 2 + s, 1}};
    for (int r = 0; r < receivers; ++r)
      shot.places.push_back({5000 + 50.0 * s - 100.0 * r, 7000});
    line.shots.push_back(shot);
  }
  return line;
}

}  // namespace hawser
