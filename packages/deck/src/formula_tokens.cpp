#include "src/formula_tokens.hpp"

#include <algorithm>
#include <cctype>

#include "hawser/base/constants.hpp"
#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/number.hpp"
#include "hawser/deck/spec_reader.hpp"

namespace hawser {
namespace {

constexpr Formula::Variable variables[] = {{'X', &SpaceTime::X, -1}, {'Y', &SpaceTime::Y, -1},
                                           {'Z', &SpaceTime::Z, -1}, {'t', &SpaceTime::t, 3},
                                           {'x', &SpaceTime::x, 0},  {'y', &SpaceTime::y, 1},
                                           {'z', &SpaceTime::z, 2}};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_in_name(char c) { return is_letter(c) || is_digit(c); }
bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

// The end of the number that begins at `begin`.
std::size_t end_of_number(const std::string& text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && (is_digit(text[end]) || text[end] == '.'))
    ++end;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    std::size_t digits = end + 1;
    if (digits < text.size() && (text[digits] == '+' || text[digits] == '-')) ++digits;
    if (digits < text.size() && is_digit(text[digits])) end = digits;
    while (end < text.size() && is_digit(text[end]))
      ++end;
  }
  return end;
}

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  for (const FormulaFunction& function : formula_functions())
    names.push_back(function.name);
  return names;
}

}  // namespace

std::vector<std::string> names_of_formulas() {
  std::vector<std::string> names = function_names();
  for (const Formula::Variable& variable : variables)
    names.emplace_back(1, variable.name);
  names.emplace_back("pi");
  std::sort(names.begin(), names.end());
  return names;
}

int FieldNames::index(const std::string& name, int along) {
  FieldReference wanted;
  wanted.field = name;
  wanted.along = along;
  const std::size_t end = name.size();
  if (end > 2 && name[end - 2] == '_' && name[end - 1] >= 'x' && name[end - 1] <= 'z') {
    wanted.field = name.substr(0, end - 2);
    wanted.component = name[end - 1] - 'x';
    wanted.of_vector = true;
  }
  for (std::size_t i = 0; i < references.size(); ++i)
    if (references[i].text() == wanted.text()) return static_cast<int>(i);
  references.push_back(wanted);
  return static_cast<int>(references.size()) - 1;
}

FormulaTokens::FormulaTokens(const std::string& text, const NamedValues* names, FieldNames* fields)
    : text_(text), fields_(fields) {
  constants_["pi"] = pi;
  for (std::size_t i = 0; names != nullptr && i < names->size(); ++i)
    constants_[(*names)[i].name] = (*names)[i].value;
  next();
}

void FormulaTokens::refuse() const {
  if (now_.kind == FormulaToken::Kind::end) throw FormulaFault{"the expression ends too early"};
  throw FormulaFault{quoted(now_.text) + " is not expected at character " +
                     std::to_string(now_.position + 1) + " of the expression"};
}

void FormulaTokens::next() {
  while (cursor_ < text_.size() && is_blank(text_[cursor_]))
    ++cursor_;
  now_ = {};
  now_.position = cursor_;
  if (cursor_ == text_.size()) return;
  const char c = text_[cursor_];
  if (is_digit(c) || c == '.') return read_number();
  if (is_letter(c)) return read_name();
  now_.kind = FormulaToken::Kind::symbol;
  for (const char* symbol : {"&&", "||", "<=", ">=", "==", "!=", "<", ">", "+", "-", "*", "/", "^",
                             "?", ":", "(", ")", ","})
    if (text_.compare(cursor_, std::char_traits<char>::length(symbol), symbol) == 0) {
      now_.text = symbol;
      cursor_ += now_.text.size();
      return;
    }
  if (c == '=') throw FormulaFault{"'=' is not allowed; == compares"};
  if (c == '"') throw FormulaFault{"texts are not allowed in an expression"};
  now_.text = trimmed(text_.substr(cursor_));
}

void FormulaTokens::read_number() {
  const std::size_t end = end_of_number(text_, cursor_);
  now_.kind = FormulaToken::Kind::number;
  now_.text = text_.substr(cursor_, end - cursor_);
  const std::string fault = hawser::read_number(now_.text, now_.number);
  if (!fault.empty()) throw FormulaFault{quoted(now_.text) + ": " + fault};
  cursor_ = end;
  if (cursor_ < text_.size() && is_letter(text_[cursor_]))
    throw FormulaFault{quoted(take_name()) + " after the number " + now_.text +
                       " is not understood"};
}

std::string FormulaTokens::take_name() {
  const std::size_t begin = cursor_;
  while (cursor_ < text_.size() && is_in_name(text_[cursor_]))
    ++cursor_;
  return text_.substr(begin, cursor_ - begin);
}

bool FormulaTokens::followed_by_parenthesis() const {
  const std::size_t next = text_.find_first_not_of(" \t", cursor_);
  return next != std::string::npos && text_[next] == '(';
}

void FormulaTokens::read_name() {
  const std::string name = take_name();
  now_.text = name;
  for (const FormulaFunction& function : formula_functions())
    if (function.name == name) now_.function = &function;
  if (followed_by_parenthesis()) {
    now_.kind = FormulaToken::Kind::function;
    if (now_.function != nullptr) return;
    std::vector<std::string> functions = function_names();
    if (fields_ != nullptr) {
      now_.kind = FormulaToken::Kind::derivative;
      for (const char* const derivative : {"dx", "dy", "dz"}) {
        if (name == derivative) return;
        functions.emplace_back(derivative);
      }
    }
    throw FormulaFault{"there is no function " + quoted(name) + "; functions are " +
                       listed(functions) + did_you_mean(name, functions)};
  }
  if (now_.function != nullptr)
    throw FormulaFault{"the function " + quoted(name) + " needs its arguments in parentheses"};
  std::vector<std::string> names;
  for (const Formula::Variable& variable : variables) {
    names.emplace_back(1, variable.name);
    if (names.back() == name) now_.variable = &variable;
  }
  now_.kind = FormulaToken::Kind::variable;
  if (now_.variable != nullptr) return;
  for (const auto& constant : constants_)
    names.push_back(constant.first);
  const auto constant = constants_.find(name);
  if (fields_ != nullptr && constant == constants_.end()) {
    now_.kind = FormulaToken::Kind::field;
    return;
  }
  if (fields_ != nullptr && name != "pi") fields_->parameters.push_back(name);
  if (constant == constants_.end())
    throw FormulaFault{"the name " + quoted(name) + " is not known; names are " + listed(names) +
                       did_you_mean(name, names)};
  now_.kind = FormulaToken::Kind::number;
  now_.number = constant->second;
}

}  // namespace hawser
