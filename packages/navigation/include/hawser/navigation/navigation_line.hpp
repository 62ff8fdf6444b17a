#pragma once
// A line as it was sailed: where the receivers of one streamer were at each shot, read from a file
// of navigation. Formats are told by the file's first characters:
//
//   CSV    columns shot, receiver, east_m, north_m; if known time_s, arc_length_m, depth_m
//   P1/90  records H, S (or V), R of UKOOA P1/90 (1990)
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "hawser/deck/diagnostics.hpp"

namespace hawser {

using Place = std::array<double, 2>;  ///< m, east and north

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
inline bool is_known(const Place& place) { return place[0] == place[0] && place[1] == place[1]; }

struct Shot {
  int number = 0;
  Location where{};              ///< in the file
  double time = no_value;        ///< s, of the file's own clock; NaN where it says none
  std::vector<Place> places{};   ///< per receiver of the line; NaN where it is missing
  std::vector<double> depths{};  ///< m, likewise; empty where the file has none
};

struct NavigationLine {
  std::string file{}, format{};
  std::vector<int> receivers{};       ///< numbers in the file
  std::vector<double> arc_lengths{};  ///< m along the cable, per receiver; empty: not said
  std::vector<Shot> shots{};
  std::vector<std::string> header{};  ///< what the file says of datum, projection and units

  bool has_times() const;
};

struct NavigationOptions {
  std::optional<int> streamer{};  ///< of a file with several
};

/// Faults go to `diagnostics`, with file, line and column, after which the line is not to be used:
/// unknown records and columns, a receiver or a shot given twice, no shots, times that go back.
NavigationLine read_navigation(const std::string& text, const std::string& file,
                               const NavigationOptions& options, Diagnostics& diagnostics);

}  // namespace hawser
