#include "src/quantity.hpp"

#include <algorithm>
#include <cctype>

#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/number.hpp"
#include "hawser/deck/spec_reader.hpp"

namespace hawser {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || (static_cast<unsigned char>(c) & 0x80);
}

bool begins_number(const std::string& text) {
  std::size_t i = text[0] == '-' || text[0] == '+' ? 1 : 0;
  if (i < text.size() && text[i] == '.') ++i;
  return i < text.size() && is_digit(text[i]);
}

bool begins_unit(const std::string& text) {
  return is_letter(text[0]) || text[0] == '%' ||
         (text.compare(0, 2, "1/") == 0 && text.size() > 2 && !is_digit(text[2]));
}

// Something that only a formula has, behind the number that a text begins with.
bool has_operator(const std::string& text) {
  for (std::size_t i = 1; i < text.size(); ++i) {
    const bool exponent =
        (text[i] == '+' || text[i] == '-') && (text[i - 1] == 'e' || text[i - 1] == 'E');
    if (!exponent && std::string("+-*/^()?<>=!&|").find(text[i]) != std::string::npos) return true;
  }
  return false;
}

struct Parts {
  std::string number, rest;
};

Parts at_first_blank(const std::string& text) {
  const std::size_t end = text.find_first_of(" \t\r\n");
  if (end == std::string::npos) return {text, ""};
  return {text.substr(0, end), trimmed(text.substr(end))};
}

bool is_name(const std::string& text) {
  return is_letter(text[0]) && std::all_of(text.begin(), text.end(), [](char c) {
           return is_letter(c) || is_digit(c) || c == '_';
         });
}

bool names_infinity(std::string text) {
  if (text[0] == '-' || text[0] == '+') text.erase(0, 1);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text == "nan" || text == "inf" || text == "infinity";
}

/// The unit that values are wanted in; none where any will do ("SI", "as the quantity").
std::optional<Unit> wanted_unit(const Reading& reading) {
  Unit unit;
  if (reading.unit.empty() || !read_unit(reading.unit, unit).empty()) return std::nullopt;
  return unit;
}

/// Converts `value`, which is in the unit `given`, to the unit that is wanted, SI if any will do.
/// `subject` and `number` are for the sentence about a wrong dimension.
std::string convert(const Reading& reading, const Unit& given, const std::string& subject,
                    const std::string& number, double& value) {
  const std::optional<Unit> wanted = wanted_unit(reading);
  if (reading.unit.empty()) return "a count has no unit";
  if (!wanted || same_dimension(given, *wanted)) {
    value *= wanted ? given.factor / wanted->factor : given.factor;
    return "";
  }
  if (wanted->is_plain_number())
    return subject + ", and a plain number is needed, such as " + quoted(number);
  const std::string example = number + " " + reading.unit;
  return subject + ", and a value in " + reading.unit + " is needed, such as " + quoted(example);
}

std::string in_unit(const Unit& unit) {
  const std::string si = si_text(unit);
  return "it is in " + unit.text + (si == unit.text ? "" : ", hence " + si);
}

// "5 kg/m^3"
std::string read_with_unit(const Reading& reading, const std::string& text, double& value,
                           Unit& unit) {
  const Parts parts = at_first_blank(text);
  std::string fault = read_number(parts.number, value);
  if (!fault.empty()) return fault;
  if (begins_number(parts.rest) && !begins_unit(parts.rest))
    return "one value is needed, " + std::to_string(split_at_blanks(text).size()) + " are given";
  if (find_named(reading.names, parts.rest) != nullptr)
    return quoted(parts.rest) + " is a parameter and no unit; write " + parts.number + "*" +
           parts.rest + " for the product";
  fault = read_unit(parts.rest, unit);
  if (!fault.empty()) return fault;
  return convert(reading, unit, in_unit(unit), parts.number, value);
}

template <class Formula>
std::string read_formula(const Reading& reading, const std::string& text, Formula& value) {
  if (names_infinity(text)) return "a finite number is needed";
  if (text[0] == '+' || text.find_first_not_of("+-") == std::string::npos)
    return "a number is needed, such as 0.5 or 1e-3";
  if (text.find_first_of("{}[]") != std::string::npos)
    return "values are written without braces or brackets, and set apart by blanks: '0 -0.5'";
  const NamedValue* const named = find_named(reading.names, text);
  std::string fault = Formula::compile(text, reading.location, reading.names, value);
  if (!fault.empty() || named == nullptr || !named->unit) return fault;
  double number = named->given;
  const Unit& unit = *named->unit;
  fault =
      convert(reading, unit, "the parameter " + quoted(text) + " is in " + unit.text, "1", number);
  if (fault.empty()) value = Formula::constant(number, unit, reading.location);
  return fault;
}

// Of one letter or more directly behind a number: "1e-3m".
std::string number_fault(const std::string& text) {
  double value = 0;
  std::string fault = read_number(text, value);
  const std::size_t digits = text.find_last_of("0123456789.");
  Unit unit;
  if (fault.empty() || digits + 1 >= text.size() || !is_letter(text[digits + 1]) ||
      !read_number(text.substr(0, digits + 1), value).empty())
    return fault;
  const std::string rest = text.substr(digits + 1);
  if (!read_unit(rest, unit).empty()) return fault;
  return "a blank is missing between the number and its unit; write '" +
         text.substr(0, digits + 1) + " " + rest + "'";
}

template <class Formula>
std::string read_any(const Reading& reading, const std::string& text, Formula& value) {
  if (text.empty()) return "a value is missing beside a ';'";
  double number = 0;
  Unit unit;
  std::string fault;
  switch (kind_of(text)) {
    case ValueKind::number:
      fault = number_fault(text);
      if (!fault.empty() && wanted_unit(reading) && reading.unit != "1")
        fault += " (in " + reading.unit + ")";
      if (!fault.empty()) return fault;
      read_number(text, number);
      value = Formula::constant(number, std::nullopt, reading.location);
      return "";
    case ValueKind::with_unit:
      fault = read_with_unit(reading, text, number, unit);
      if (fault.empty()) value = Formula::constant(number, unit, reading.location);
      return fault;
    default: return read_formula(reading, text, value);
  }
}

}  // namespace

const NamedValue* find_named(const NamedValues* names, const std::string& name) {
  for (std::size_t i = 0; names != nullptr && i < names->size(); ++i)
    if ((*names)[i].name == name) return &(*names)[i];
  return nullptr;
}

ValueKind kind_of(const std::string& text) {
  if (text.empty() || !begins_number(text)) return ValueKind::formula;
  const Parts parts = at_first_blank(text);
  if (parts.rest.empty()) return has_operator(text) ? ValueKind::formula : ValueKind::number;
  const bool unit =
      !has_operator(parts.number) && (begins_unit(parts.rest) || begins_number(parts.rest));
  return unit ? ValueKind::with_unit : ValueKind::formula;
}

std::string read_expression(const Reading& reading, const std::string& text, Expression& value) {
  return read_any(reading, text, value);
}
std::string read_expression(const Reading& reading, const std::string& text,
                            FieldExpression& value) {
  std::string fault = read_any(reading, text, value);
  // A parameter alone has become a constant with its unit.
  if (fault.empty() && value.parameters().empty() && find_named(reading.names, text) != nullptr)
    value.uses_parameter(text);
  return fault;
}

std::string read_quantity(const Reading& reading, const std::string& text, double& value) {
  Expression expression;
  std::string fault = read_expression(reading, text, expression);
  if (!fault.empty() && is_name(text) && !names_infinity(text) &&
      find_named(reading.names, text) == nullptr) {
    std::vector<std::string> names;
    for (std::size_t i = 0; reading.names != nullptr && i < reading.names->size(); ++i)
      names.push_back((*reading.names)[i].name);
    return "a number is needed, such as 0.5 or 1e-3, or the name of a parameter; there " +
           (names.empty() ? std::string("are none") : "are " + listed(names)) +
           did_you_mean(text, names);
  }
  if (!fault.empty()) return fault;
  if (!expression.is_constant())
    return "one fixed number is needed, but this depends on place or time";
  value = expression({});
  // A formula is in SI units; what is written with a unit has been converted already.
  const std::optional<Unit> wanted = wanted_unit(reading);
  if (wanted && kind_of(text) == ValueKind::formula && !expression.unit()) value /= wanted->factor;
  return "";
}

std::vector<std::string> split_values(const std::string& text) {
  if (text.find(';') != std::string::npos) return split_at(text, ';');
  std::vector<std::string> values;
  int with_unit = 0;
  for (const std::string& token : split_at_blanks(text)) {
    const bool plain = token.find_first_of(",(*+<>?=!&|") == std::string::npos;
    if (begins_number(token) && !begins_unit(token) && !has_operator(token)) {
      values.push_back(token);
    } else if (!values.empty() && plain && begins_unit(token)) {
      with_unit += values.back().find(' ') == std::string::npos ? 1 : 0;
      values.back() += " " + token;
    } else {
      return {text};
    }
  }
  // The unit at the end is for all values when no other has one.
  const std::size_t blank = values.empty() ? std::string::npos : values.back().find(' ');
  if (with_unit == 1 && blank != std::string::npos)
    for (std::size_t i = 0; i + 1 < values.size(); ++i)
      values[i] += values.back().substr(blank);
  return values;
}

}  // namespace hawser
