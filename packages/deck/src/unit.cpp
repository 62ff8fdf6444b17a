#include "hawser/deck/unit.hpp"

#include <cmath>
#include <cstdlib>

#include "hawser/base/constants.hpp"
#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/spec_reader.hpp"

namespace hawser {
namespace {

using Powers = std::array<int, Unit::base_units>;

constexpr std::size_t longest_unit = 60;  // also bounds the nesting of parentheses
constexpr int greatest_power = 9;

struct NamedUnit {
  const char* name;
  double factor;
  Powers powers;  // m kg s A K mol cd rad
  bool takes_prefix;
};

const std::vector<NamedUnit>& table() {
  static const std::vector<NamedUnit> units = {
      {"m", 1, {1}, true},
      {"g", 1e-3, {0, 1}, true},
      {"s", 1, {0, 0, 1}, true},
      {"A", 1, {0, 0, 0, 1}, true},
      {"K", 1, {0, 0, 0, 0, 1}, true},
      {"mol", 1, {0, 0, 0, 0, 0, 1}, true},
      {"cd", 1, {0, 0, 0, 0, 0, 0, 1}, false},
      {"rad", 1, {0, 0, 0, 0, 0, 0, 0, 1}, true},
      {"N", 1, {1, 1, -2}, true},
      {"Pa", 1, {-1, 1, -2}, true},
      {"J", 1, {2, 1, -2}, true},
      {"W", 1, {2, 1, -3}, true},
      {"Hz", 1, {0, 0, -1}, true},
      {"C", 1, {0, 0, 1, 1}, false},
      {"V", 1, {2, 1, -3, -1}, true},
      {"bar", 1e5, {-1, 1, -2}, true},
      {"l", 1e-3, {3}, true},
      {"t", 1000, {0, 1}, false},
      {"min", 60, {0, 0, 1}, false},
      {"h", 3600, {0, 0, 1}, false},
      {"d", 86400, {0, 0, 1}, false},
      {"kn", 1852.0 / 3600, {1, 0, -1}, false},
      {"nmi", 1852, {1}, false},
      {"ft", 0.3048, {1}, false},
      {"in", 0.0254, {1}, false},
      {"lbf", 4.4482216152605, {1, 1, -2}, false},
      {"deg", pi / 180, {0, 0, 0, 0, 0, 0, 0, 1}, false},
      {"rev", 2 * pi, {0, 0, 0, 0, 0, 0, 0, 1}, false},
      {"%", 1e-2, {}, false},
  };
  return units;
}

struct Prefix {
  const char* name;
  double factor;
};
constexpr Prefix prefixes[] = {{"n", 1e-9}, {"u", 1e-6}, {"µ", 1e-6}, {"m", 1e-3}, {"c", 1e-2},
                               {"d", 1e-1}, {"h", 1e2},  {"k", 1e3},  {"M", 1e6},  {"G", 1e9}};

const NamedUnit* find_unit(const std::string& name) {
  for (const NamedUnit& unit : table())
    if (name == unit.name) return &unit;
  return nullptr;
}

struct Word {
  const char *word, *unit;
};
constexpr Word words[] = {
    {"knot", "kn"},     {"knots", "kn"},    {"kt", "kn"},    {"kts", "kn"},   {"degree", "deg"},
    {"degrees", "deg"}, {"°", "deg"},       {"sec", "s"},    {"second", "s"}, {"seconds", "s"},
    {"minute", "min"},  {"minutes", "min"}, {"hr", "h"},     {"hour", "h"},   {"hours", "h"},
    {"day", "d"},       {"days", "d"},      {"metre", "m"},  {"metres", "m"}, {"meter", "m"},
    {"meters", "m"},    {"tonne", "t"},     {"tonnes", "t"}, {"newton", "N"}, {"pascal", "Pa"},
    {"watt", "W"},      {"percent", "%"},   {"inch", "in"}};

std::string unknown_unit(const std::string& name) {
  for (const Word& word : words)
    if (name == word.word)
      return "there is no unit " + quoted(name) + "; did you mean '" + word.unit + "'?";
  std::vector<std::string> names = unit_names();
  for (const char* common : {"km", "cm", "mm", "kg", "kN", "MN", "kPa", "MPa", "GPa", "ms"})
    names.emplace_back(common);
  return "there is no unit " + quoted(name) + did_you_mean(name, names);
}

std::string find_with_prefix(const std::string& name, Unit& unit) {
  if (const NamedUnit* const found = find_unit(name)) {
    unit.factor = found->factor, unit.powers = found->powers;
    return "";
  }
  for (const Prefix& prefix : prefixes) {
    const std::string start = prefix.name;
    if (name.compare(0, start.size(), start) != 0) continue;
    const NamedUnit* const found = find_unit(name.substr(start.size()));
    if (found == nullptr || !found->takes_prefix) continue;
    // A division, where that is exact: 1 mm is the double next to 0.001.
    unit.factor = prefix.factor < 1 ? found->factor / std::round(1 / prefix.factor)
                                    : found->factor * prefix.factor;
    if (name == "kg") unit.factor = 1;
    unit.powers = found->powers;
    return "";
  }
  return unknown_unit(name);
}

/// unit := factor (('*' | '/' | blank) factor)*;  factor := (name | '1' | '(' unit ')') ['^' power]
class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  std::string whole(Unit& unit) {
    product(unit);
    if (fault_.empty() && at_ < text_.size()) fault_ = not_expected();
    return fault_;
  }

 private:
  void product(Unit& unit) {
    unit = {};
    for (int sign = 1;;) {
      Unit next;
      factor(next);
      if (!fault_.empty()) return;
      unit.factor *= sign > 0 ? next.factor : 1 / next.factor;
      for (std::size_t i = 0; i < unit.powers.size(); ++i)
        unit.powers[i] += sign * next.powers[i];
      const bool blank = skip_blanks();
      if (at_ == text_.size() || text_[at_] == ')') return;
      sign = text_[at_] == '/' ? -1 : 1;
      if (text_[at_] == '/' || text_[at_] == '*')
        ++at_;
      else if (!blank) {
        fault_ = not_expected();
        return;
      }
      skip_blanks();
    }
  }

  void factor(Unit& unit) {
    if (at_ < text_.size() && text_[at_] == '(') {
      ++at_;
      product(unit);
      if (fault_.empty() && (at_ == text_.size() || text_[at_] != ')'))
        fault_ = "a closing parenthesis is missing in the unit";
      ++at_;
    } else if (at_ < text_.size() && text_[at_] == '1') {
      ++at_;
    } else {
      named(unit);
    }
    if (fault_.empty() && at_ < text_.size() && text_[at_] == '^') power(unit);
  }

  void named(Unit& unit) {
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           std::string(" \t\r\n*/^()0123456789+-.,;").find(text_[at_]) == std::string::npos)
      ++at_;
    fault_ =
        at_ == begin ? not_expected() : find_with_prefix(text_.substr(begin, at_ - begin), unit);
  }

  void power(Unit& unit) {
    const char* begin = text_.c_str() + at_ + 1;
    char* end = nullptr;
    const long power = std::strtol(begin, &end, 10);
    if (end == begin || std::labs(power) > greatest_power) {
      fault_ = "a power of a unit is a whole number, such as m^2";
      return;
    }
    at_ += 1 + static_cast<std::size_t>(end - begin);
    unit.factor = std::pow(unit.factor, static_cast<double>(power));
    for (int& p : unit.powers) {
      p *= static_cast<int>(power);
      if (std::abs(p) > greatest_power)
        fault_ = "powers of a unit go up to " + std::to_string(greatest_power);
    }
  }

  bool skip_blanks() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::string(" \t\r\n").find(text_[at_]) != std::string::npos)
      ++at_;
    return at_ > begin;
  }

  std::string not_expected() const {
    return at_ < text_.size()
               ? quoted(text_.substr(at_)) + " is not expected in a unit, such as m/s or kg/m^3"
               : "the unit ends too early";
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::string fault_;
};

}  // namespace

std::string read_unit(const std::string& text, Unit& unit) {
  const std::string given = trimmed(text);
  if (given.size() > longest_unit) return quoted(given) + " is too long for a unit";
  std::string fault = Parser(given).whole(unit);
  unit.text = given;
  if (fault.empty() && !(std::isfinite(unit.factor) && unit.factor > 0))
    fault = quoted(given) + " is too large or too small for a unit";
  return fault;
}

bool same_dimension(const Unit& a, const Unit& b) { return a.powers == b.powers; }

std::string si_text(const Unit& unit) {
  if (unit.is_plain_number()) return "1";
  for (const char* name : {"N", "Pa", "J", "W", "V"})
    if (unit.powers == find_unit(name)->powers) return name;
  static const char* const names[] = {"m", "kg", "s", "A", "K", "mol", "cd", "rad"};
  // Mass first, as in kg/m^3.
  static const std::size_t order[] = {1, 0, 2, 3, 4, 5, 6, 7};
  std::string above, below;
  for (const std::size_t i : order) {
    const int power = std::abs(unit.powers[i]);
    if (power == 0) continue;
    const std::string factor = names[i] + (power > 1 ? "^" + std::to_string(power) : std::string());
    if (unit.powers[i] > 0)
      above += (above.empty() ? "" : " ") + factor;
    else
      below += "/" + factor;
  }
  return (above.empty() ? "1" : above) + below;
}

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  for (const NamedUnit& unit : table())
    names.emplace_back(unit.name);
  return names;
}

}  // namespace hawser
