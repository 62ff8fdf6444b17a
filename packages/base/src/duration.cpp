#include "hawser/base/duration.hpp"

#include <cctype>
#include <cmath>
#include <string_view>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

struct Unit {
  char letter;
  double seconds;
};
constexpr Unit units[] = {{'d', 86400}, {'h', 3600}, {'m', 60}, {'s', 1}};  // in their order

[[noreturn]] void refuse(const std::string& text) {
  throw Error(ExitCode::usage, "'" + text +
                                   "' is no time; needed is one such as 5h50m, 90m, 1d12h, or a "
                                   "number of seconds, greater than 0");
}

}  // namespace

double read_duration(const std::string& text) {
  double total = 0;
  std::size_t next_unit = 0;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() &&
           (std::isdigit(static_cast<unsigned char>(text[end])) != 0 || text[end] == '.'))
      ++end;
    const std::string digits = text.substr(at, end - at);
    if (digits.empty() || digits == "." || digits.find('.') != digits.rfind('.')) refuse(text);
    const double number = std::stod(digits);
    if (end == text.size()) {
      if (at > 0) refuse(text);
      total = number;
      break;
    }
    while (next_unit < std::size(units) && units[next_unit].letter != text[end])
      ++next_unit;
    if (next_unit == std::size(units)) refuse(text);
    total += number * units[next_unit++].seconds;
    at = end + 1;
  }
  if (!(total > 0) || !std::isfinite(total)) refuse(text);
  return total;
}

}  // namespace hawser
