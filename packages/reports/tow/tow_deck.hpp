#pragma once
// What a deck says of a towed cable.
#include <optional>
#include <string>
#include <vector>

#include "hawser/base/constants.hpp"
#include "hawser/deck/spec.hpp"

namespace hawser {

constexpr double degree = pi / 180;  // rad

/// What the receivers' places are on a chart, and a file that says so.
struct NavigationFileDeck {
  Located<std::string> file, crs, epoch;
  std::string line = "1";
  std::vector<double> origin;  ///< m, easting and northing of x = y = 0
  int first_shot = 1, streamer = 1;
  double depth = 0;  ///< m, of the cable in the plane
  static Spec<NavigationFileDeck> spec();
};

/// Receivers along the towed cable, as a table over time.
struct ReceiversDeck {
  double spacing = 12.5;  ///< m along the cable at rest, as the next
  Located<double> first;
  Located<std::vector<double>> at;     ///< m, instead of first and spacing
  Located<std::vector<double>> times;  ///< s
  int every = 0;                       ///< steps
  Located<double> shot_distance;       ///< m of the tow point's way; 0: none
  std::optional<NavigationFileDeck> navigation;
  static Spec<ReceiversDeck> spec();
};

/// The towed cable's report: positioning errors and the tow force.
struct TowDeck {
  std::string name;
  Located<std::string> cable, tow_point;
  Located<double> angle;                      ///< degrees, of the tow axis from upstream
  std::optional<double> speed;                ///< m/s
  std::optional<double> current;              ///< m/s, along -y
  std::optional<Located<std::string>> track;  ///< instead of angle and speed
  enum class Course { as_said, motion };
  Course course = Course::as_said;  ///< motion: the axis is where the tow point goes
  std::optional<ReceiversDeck> receivers;
  static Spec<TowDeck> spec();

  /// Name of a quantity or file: NAME_what, or what it is alone.
  std::string named(const std::string& what) const {
    return name.empty() ? what : name + "_" + what;
  }
};

}  // namespace hawser
