#pragma once
// The cubic spline f that is least in  sum of w_i (y_i - f(t_i))^2 + lambda int f''^2 dt,  with the
// time that belongs to a row as its weight w_i: C2, straight beyond the ends' curvature of zero.
//
// With lambda = (period / 2 pi)^4 it is, away from the ends, a filter with the response
// 1 / (1 + lambda omega^4): half at `period`. Found by Reinsch's algorithm in a time that grows
// with the number of rows (Green and Silverman, Nonparametric Regression, 1994, section 2.3).
#include <vector>

namespace hawser {

class SmoothingSpline {
 public:
  /// `times` in s, ascending; `period` in s, 0 for the interpolating spline.
  SmoothingSpline(const std::vector<double>& times, const std::vector<double>& values,
                  double period);

  /// Within the times.
  double value(double time) const;
  double rate(double time) const;  ///< per s

 private:
  std::size_t piece(double time) const;

  std::vector<double> times_, values_, curvatures_;
};

}  // namespace hawser
