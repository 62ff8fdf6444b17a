#include "hawser/deck/value.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/number.hpp"
#include "hawser/deck/spec_reader.hpp"
#include "src/quantity.hpp"

namespace hawser {
namespace {

std::string range_fault(const Reading& reading, double value) {
  for (const Rules::NumberCheck& check : reading.rules.numbers) {
    if (check.holds(value)) continue;
    const bool bare = reading.unit.empty() || reading.unit == "1";
    return "it must be " + check.text + (bare ? "" : " " + reading.unit);
  }
  return "";
}

std::string number_fault(const Reading& reading, const std::string& text, double& value) {
  const std::string fault = read_quantity(reading, text, value);
  return fault.empty() ? range_fault(reading, value) : fault;
}

std::string length_fault(const Reading& reading, std::size_t length) {
  const Rules& rules = reading.rules;
  const int count = static_cast<int>(length);
  if (count >= rules.least_length && (rules.greatest_length == 0 || count <= rules.greatest_length))
    return "";
  Rules of_length;
  of_length.least_length = rules.least_length;
  of_length.greatest_length = rules.greatest_length;
  return of_length.range_text() + " needed, " + std::to_string(count) + " given";
}

std::string list_fault(const Reading& reading, const std::vector<std::string>& values) {
  const auto has_unit = [](const std::string& value) { return value.find(' ') != value.npos; };
  const auto units = std::count_if(values.begin(), values.end(), has_unit);
  if (reading.text.find(';') == std::string::npos && units > 0 &&
      static_cast<std::size_t>(units) < values.size())
    return "every value of the list needs its unit, or only the last one, for all";
  return length_fault(reading, values.size());
}

std::string word_fault(const Reading& reading, const std::string& word) {
  const auto& allowed = reading.rules.words;
  const bool known = std::find(allowed.begin(), allowed.end(), word) != allowed.end();
  return allowed.empty() || known ? "" : not_among(word, allowed);
}

// Names the faulty one when there are several.
std::string of_part(const std::string& part, std::size_t count, const std::string& fault) {
  return fault.empty() || count < 2 ? fault : "in " + quoted(part) + ", " + fault;
}

template <class Formula>
std::string expression_fault(const Reading& reading, const std::string& text, Formula& value) {
  const std::string fault = read_expression(reading, text, value);
  return fault.empty() && value.is_constant() ? range_fault(reading, value({})) : fault;
}

/// "L 0" is no formula, but would be two values with a ';' between them. `fault` goes on to say so.
std::string with_separator(const Reading& reading, std::size_t parts, const std::string& fault) {
  const std::vector<std::string> words = split_at_blanks(reading.text);
  if (fault.empty() || parts > 1 || words.size() < 2) return fault;
  std::string apart;
  for (const std::string& word : words) {
    Expression value;
    if (!read_expression(reading, word, value).empty()) return fault;
    apart += (apart.empty() ? "" : "; ") + word;
  }
  return fault +
         "; values of a list that are names or formulas are set apart by ';': " + quoted(apart);
}

template <class Formula>
std::string one_formula(const Reading& reading, Formula& value) {
  const std::size_t count = split_values(reading.text).size();
  if (count > 1) return "one value is needed, " + std::to_string(count) + " are given";
  return expression_fault(reading, reading.text, value);
}

template <class Formula>
std::string formulas(const Reading& reading, std::vector<Formula>& value) {
  const auto parts = split_values(reading.text);
  value.assign(parts.size(), {});
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string fault = expression_fault(reading, parts[i], value[i]);
    if (!fault.empty())
      return with_separator(reading, parts.size(), of_part(parts[i], parts.size(), fault));
  }
  return list_fault(reading, parts);
}

template <class List>
std::string joined(const List& list, const std::string& separator) {
  std::string result;
  for (const auto& value : list) {
    if (&value != &list.front()) result += separator;
    result += write_value(value);
  }
  return result;
}

}  // namespace

std::string read_value(const Reading& reading, double& value) {
  return number_fault(reading, reading.text, value);
}

std::string read_value(const Reading& reading, int& value) {
  std::string fault;
  if (kind_of(reading.text) == ValueKind::number) {
    fault = read_whole_number(reading.text, value);
  } else {
    double number = 0;
    fault = read_quantity(reading, reading.text, number);
    const bool fits = std::abs(number) <= std::numeric_limits<int>::max();
    if (fault.empty() && !(fits && number == std::floor(number)))
      fault = "a whole number is needed, and this is " + write_value(number);
    if (fault.empty()) value = static_cast<int>(number);
  }
  return fault.empty() ? range_fault(reading, value) : fault;
}

std::string read_value(const Reading& reading, bool& value) {
  value = reading.text == "true";
  return value || reading.text == "false" ? "" : "it must be true or false";
}

std::string read_value(const Reading& reading, std::string& value) {
  value = reading.text;
  return word_fault(reading, value);
}

std::string read_value(const Reading& reading, Expression& value) {
  return one_formula(reading, value);
}
std::string read_value(const Reading& reading, FieldExpression& value) {
  return one_formula(reading, value);
}
std::string read_value(const Reading& reading, Expressions& value) {
  return formulas(reading, value);
}
std::string read_value(const Reading& reading, FieldExpressions& value) {
  return formulas(reading, value);
}

std::string read_value(const Reading& reading, std::vector<double>& value) {
  const auto parts = split_values(reading.text);
  value.assign(parts.size(), 0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string fault = number_fault(reading, parts[i], value[i]);
    if (!fault.empty())
      return with_separator(reading, parts.size(), of_part(parts[i], parts.size(), fault));
  }
  return list_fault(reading, parts);
}

std::string read_value(const Reading& reading, std::vector<std::string>& value) {
  value = split_at_blanks(reading.text);
  for (const std::string& word : value) {
    std::string fault = word_fault(reading, word);
    if (word.find_first_of(",;") != std::string::npos)
      fault = "names are set apart by blanks, not by ',' or ';'";
    if (!fault.empty()) return of_part(word, value.size(), fault);
  }
  return length_fault(reading, value.size());
}

std::string read_value(const Reading& reading, Domain& value) {
  value = {};
  return read_value(reading, value.regions);
}

std::string write_value(double value) {
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), result.ptr};
}

std::string write_value(int value) { return std::to_string(value); }
std::string write_value(bool value) { return value ? "true" : "false"; }
std::string write_value(const std::string& value) { return value; }
std::string write_value(const Expression& value) { return value.text(); }
std::string write_value(const std::vector<double>& value) { return joined(value, " "); }
std::string write_value(const std::vector<std::string>& value) { return joined(value, " "); }
std::string write_value(const Expressions& value) { return joined(value, "; "); }
std::string write_value(const FieldExpression& value) { return value.text(); }
std::string write_value(const FieldExpressions& value) { return joined(value, "; "); }
std::string write_value(const Domain& value) { return write_value(value.regions); }

std::string type_name(const double&) { return "number"; }
std::string type_name(const int&) { return "whole number"; }
std::string type_name(const bool&) { return "true or false"; }
std::string type_name(const std::string&) { return "text"; }
std::string type_name(const Expression&) { return "expression"; }
std::string type_name(const std::vector<double>&) { return "list of numbers"; }
std::string type_name(const std::vector<std::string>&) { return "list of names"; }
std::string type_name(const Expressions&) { return "list of expressions"; }
std::string type_name(const FieldExpression&) { return "expression of fields"; }
std::string type_name(const FieldExpressions&) { return "list of expressions of fields"; }
std::string type_name(const Domain& value) { return type_name(value.regions); }

}  // namespace hawser
