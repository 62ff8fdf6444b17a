#pragma once
// The steps in which a line of navigation is made ready. Each reads what those before it have
// found.
#include "hawser/replay/measured_line.hpp"

namespace hawser {

double distance(const Place& a, const Place& b);  ///< m
double median(std::vector<double> values);        ///< NaN of none

/// The head's track: its times, its smoothing, the times of shots.
void find_track(const NavigationLine& line, const LineOptions& options, MeasuredLine& result,
                Diagnostics& diagnostics);

/// The cable's shape at the first shot, smoothed, from where the head's track begins, as long as
/// the cable and a little more.
void find_shape(const LineOptions& options, MeasuredLine& result);

}  // namespace hawser
