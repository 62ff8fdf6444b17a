#pragma once
// Units as decks write them behind a number: "0.5 m/s", "60 kg/m", "2 kn", "1e7 N m^2", "W/(m K)".
//
// A blank or * multiplies, / divides by the one factor behind it, ^ raises to a whole power, and
// parentheses group. Angles are a dimension of their own: 30 deg is no plain number.
#include <array>
#include <string>
#include <vector>

namespace hawser {

struct Unit {
  static constexpr std::size_t base_units = 8;  ///< m kg s A K mol cd rad

  double factor = 1;  ///< in SI units
  std::array<int, base_units> powers{};
  std::string text = "1";  ///< as written

  bool is_si() const { return factor == 1; }
  bool is_plain_number() const { return powers == std::array<int, base_units>{}; }
};

/// Sets `unit` and returns "", or returns what is wrong.
std::string read_unit(const std::string& text, Unit& unit);

bool same_dimension(const Unit& a, const Unit& b);

/// The SI unit of the same dimension: "m/s" for knots, "1" for a plain number.
std::string si_text(const Unit& unit);

/// Every unit by its name, without prefixes; for the manual.
std::vector<std::string> unit_names();

}  // namespace hawser
