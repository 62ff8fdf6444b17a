#include "hawser/deck/number.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/spec_reader.hpp"

namespace hawser {
namespace {

// from_chars knows no leading plus sign.
const char* skip_plus(const std::string& text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return text.data() + (plus ? 1 : 0);
}

}  // namespace

std::string read_number(const std::string& text, double& value) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(skip_plus(text), end, number);
  const std::string rest(stop, end);
  if (error == std::errc::invalid_argument) return "a number is needed, such as 0.5 or 1e-3";
  if (!rest.empty() && rest[0] == ',')
    return "a number has no comma; write 1000 or 1e3 for a thousand, 0.5 for a half, and blanks "
           "between the values of a list";
  if (!rest.empty()) return quoted(rest) + " after the number is not understood";
  if (error == std::errc::result_out_of_range)
    return "it is too large or too small for a number of double precision";
  if (!std::isfinite(number)) return "a finite number is needed";
  value = number;
  return "";
}

std::string read_whole_number(const std::string& text, int& value) {
  int number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(skip_plus(text), end, number);
  if (error == std::errc() && stop == end) {
    value = number;
    return "";
  }
  if (error == std::errc::result_out_of_range && stop == end)
    return "it is too large; whole numbers go up to " +
           std::to_string(std::numeric_limits<int>::max());
  double real = 0;
  const std::string fault = read_number(text, real);
  if (fault.empty()) return "a whole number is needed, such as 10, without a point or exponent";
  return error == std::errc::invalid_argument ? "a whole number is needed, such as 10" : fault;
}

std::vector<std::string> split_at_blanks(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> parts;
  for (std::string part; stream >> part;)
    parts.push_back(part);
  return parts;
}

std::vector<std::string> split_at(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(trimmed(text.substr(begin, end - begin)));
    if (end == std::string::npos) return parts;
    begin = end + 1;
  }
}

}  // namespace hawser
