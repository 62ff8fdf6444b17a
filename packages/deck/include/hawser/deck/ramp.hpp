#pragma once
// The smooth step of decks' formulas and of tracks.

namespace hawser {

/// 0 before `start`, 1 after start + duration, 10 s^3 - 15 s^4 + 6 s^5 between: C2.
inline double ramp(double t, double start, double duration) {
  if (t <= start) return 0;
  if (t >= start + duration) return 1;
  const double s = (t - start) / duration;
  return s * s * s * (10 + s * (-15 + s * 6));
}

/// The integral of ramp over t: the way of a ramped unit speed.
inline double ramp_distance(double t, double start, double duration) {
  if (t <= start) return 0;
  if (t >= start + duration) return t - start - duration / 2;
  const double s = (t - start) / duration;
  return duration * s * s * s * s * (2.5 + s * (-3 + s));
}

}  // namespace hawser
