#pragma once
// What of a quantity over time repeats itself: its periods, found without knowing them.
#include <vector>

namespace hawser {

/// A period goes from one rise through the middle to the next. Means are over the periods looked
/// at.
struct Oscillation {
  int periods = 0;               ///< looked at; 0 where there is none, and nothing else is set
  double from = 0, to = 0;       ///< s, where the first of them begins and the last one ends
  double average = 0;            ///< over time, in the unit of the quantity, as are these two:
  double middle = 0;             ///< (maximum + minimum)/2 of a period
  double amplitude = 0;          ///< (maximum - minimum)/2 of a period
  double frequency = 0;          ///< Hz
  double amplitude_scatter = 0;  ///< largest departure of one period from the mean, relative
  double frequency_scatter = 0;  ///< likewise
};

/// Of samples at ascending times, the last `periods` periods, or as many as there are. A rise
/// counts when it comes from a quarter of the amplitude below the middle and reaches a quarter
/// above it, so that a ripple makes no period. Extremes are those of parabolas through three
/// samples; a period of n samples has them to O(n^-3).
Oscillation find_oscillation(const std::vector<double>& times, const std::vector<double>& values,
                             int periods);

}  // namespace hawser
