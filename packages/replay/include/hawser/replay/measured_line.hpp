#pragma once
// A line of navigation made ready to be replayed: receivers counted from the head on, places from
// an origin at the head, times from the first shot, the head's track smoothed, the first shot's
// shape as a curve along which a cable of the right length can be laid.
#include <memory>

#include "hawser/navigation/navigation_line.hpp"
#include "hawser/values/smoothing_spline.hpp"

namespace hawser {

struct LineOptions {
  std::optional<double> speed{};         ///< m/s along the head's track, for a file without times
  std::optional<double> spacing{};       ///< m between receivers of successive numbers
  std::optional<double> smooth{};        ///< s, SmoothingSpline::period of the head's track
  std::optional<double> shape_smooth{};  ///< m, the same along the shape
  std::optional<double> longest_gap{};   ///< s without the head that are bridged
};

struct MeasuredLine {
  std::string file{}, format{};
  std::vector<std::string> frame{};  ///< header records on datum, projection and units
  std::vector<int> shot_numbers{}, receivers{};
  std::vector<double> arc_lengths{};         ///< m, per receiver, from 0 at the head
  std::vector<double> times{};               ///< s, per shot, from 0
  std::vector<std::vector<Place>> places{};  ///< [shot][receiver], m from the origin; NaN: missing
  Place origin{};                            ///< m, in the file's frame
  std::vector<double> head_times{};          ///< s, of the fixes of the head
  std::vector<Place> head{};                 ///< m from the origin, as measured
  double smooth = 0;                         ///< s
  double head_noise = 0;                     ///< m, estimated, per direction
  double speed = 0;                          ///< m/s, mean along the smoothed track
  std::vector<std::array<double, 3>> shape{};  ///< m, of the cable at the first shot
  double shape_smooth = 0;                     ///< m
  std::vector<std::string> notes{};            ///< what was found out rather than said

  double length() const { return arc_lengths.back(); }  ///< m, of the cable
  Place head_at(double time) const;                     ///< m, on the smoothed track
  std::shared_ptr<const SmoothingSpline> east{}, north{};
};

/// Faults go to `diagnostics`, after which the result is not to be used: no times and no speed (or
/// both), spacings that the places contradict, a head that jumps or is missing too long.
MeasuredLine prepare_line(const NavigationLine& line, const LineOptions& options,
                          Diagnostics& diagnostics);

}  // namespace hawser
