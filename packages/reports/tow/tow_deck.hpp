#pragma once
// What a deck says of a towed cable.
#include <optional>
#include <string>
#include <vector>

#include "hawser/base/constants.hpp"
#include "hawser/deck/spec.hpp"

namespace hawser {

constexpr double degree = pi / 180;  // rad

/// Receivers along the towed cable, as a table over time.
struct ReceiversDeck {
  double spacing = 12.5, first = 0;  ///< m along the cable at rest
  std::vector<double> times;         ///< s
  int every = 0;                     ///< steps
  static Spec<ReceiversDeck> spec();
};

/// The towed cable's report: positioning errors and the tow force.
struct TowDeck {
  std::string name;
  Located<std::string> cable, tow_point;
  double angle = 0;                           ///< degrees, of the tow axis from upstream
  double speed = 0;                           ///< m/s
  double current = 0;                         ///< m/s, along -y
  std::optional<Located<std::string>> track;  ///< instead of angle and speed
  std::optional<ReceiversDeck> receivers;
  static Spec<TowDeck> spec();

  /// Name of a quantity or file: NAME_what, or what it is alone.
  std::string named(const std::string& what) const {
    return name.empty() ? what : name + "_" + what;
  }
};

}  // namespace hawser
