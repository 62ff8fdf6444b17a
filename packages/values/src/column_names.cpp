#include "src/column_names.hpp"

#include <cctype>

#include "hawser/base/constants.hpp"

namespace hawser {
namespace {

using Kind = TableQuantity::Kind;

// Beyond these a value is taken for a fill value or a wrong unit.
constexpr double longest_time = 1e11;      // s, three thousand years
constexpr double longest_way = 1e7;        // m, a quarter of the Earth's girth
constexpr double farthest_on_chart = 1e8;  // m, eastings with the zone in front
constexpr double greatest_speed = 50;      // m/s
constexpr double greatest_of_any = 1e15;

double plausible(const std::string& field) {
  if (field == "velocity") return greatest_speed;
  if (field == "displacement") return longest_way;
  return field == "pressure" ? 1e9 : greatest_of_any;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

}  // namespace

std::vector<Named> known_to(const WantedValues& wanted) {
  const auto place = [](const char* name, std::size_t index, bool chart) {
    const double far = chart ? farthest_on_chart : longest_way;
    return Named{name, "m", {Kind::place, index, chart, -far, far}};
  };
  std::vector<Named> known;
  for (const char* name : {"time", "t"})
    known.push_back({name, "s", {Kind::time, 0, false, -longest_time, longest_time}});
  known.push_back(place("x", 0, false));
  known.push_back(place("y", 1, false));
  known.push_back(place("z", 2, false));
  known.push_back(place("easting", 0, true));
  known.push_back(place("northing", 1, true));
  const double most = plausible(wanted.field);
  for (std::size_t c = 0; c < wanted.components.size(); ++c) {
    const std::string& component = wanted.components[c];
    const TableQuantity quantity{Kind::component, c, false, -most, most};
    known.push_back(
        {wanted.field + (component.empty() ? "" : "_" + component), wanted.unit, quantity});
    if (wanted.field == "velocity" && c < 3)
      known.push_back({std::string(1, "uvw"[c]), wanted.unit, quantity});
  }
  known.push_back({"speed", "m/s", {Kind::speed, 0, false, 0, greatest_speed}});
  for (const char* name : {"direction", "heading", "course"})
    known.push_back({name, "deg", {Kind::direction, 0, false, -2 * pi, 2 * pi}});
  return known;
}

std::string unit_text(std::string ending) {
  while (!ending.empty() && (ending[0] == '_' || ending[0] == ' '))
    ending.erase(0, 1);
  const bool bracket = ending.size() > 1 && ((ending.front() == '[' && ending.back() == ']') ||
                                             (ending.front() == '(' && ending.back() == ')'));
  if (bracket) return ending.substr(1, ending.size() - 2);
  replace_all(ending, "_per_", "/");
  replace_all(ending, "_", " ");
  std::string text;
  for (std::size_t i = 0; i < ending.size(); ++i) {
    const bool sign = ending[i] == '-' && i + 1 < ending.size() && is_digit(ending[i + 1]);
    if (i > 0 && is_letter(ending[i - 1]) && (is_digit(ending[i]) || sign)) text += '^';
    text += ending[i];
  }
  return text;
}

std::string with_unit(const std::string& name, std::string unit) {
  if (unit == "1") return name;
  replace_all(unit, "/", "_per_");
  replace_all(unit, " ", "_");
  replace_all(unit, "^", "");
  return name + "_" + unit;
}

std::string with_unit(const Named& named) { return with_unit(named.name, named.unit); }

const Named* quantity_of(const std::string& column, const std::vector<Named>& known) {
  const Named* found = nullptr;
  for (const Named& named : known) {
    const std::size_t size = named.name.size();
    if (column.compare(0, size, named.name) != 0) continue;
    const bool ends =
        column.size() == size || std::string("_ [(").find(column[size]) != column.npos;
    if (ends && (found == nullptr || size > found->name.size())) found = &named;
  }
  return found;
}

}  // namespace hawser
