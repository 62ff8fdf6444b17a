#include "src/formula.hpp"

#include <algorithm>
#include <cctype>

#include "hawser/base/constants.hpp"
#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/ramp.hpp"
#include "hawser/deck/spec_reader.hpp"
#include "src/number.hpp"

namespace hawser {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_in_name(char c) { return is_letter(c) || is_digit(c); }

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

template <class Map>
std::vector<std::string> keys(const Map& map) {
  std::vector<std::string> result;
  for (const auto& entry : map)
    result.push_back(entry.first);
  return result;
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
  for (const std::string& candidate : words)
    if (candidate == word) return true;
  return false;
}

std::string sentence(const mu::ParserError& error) {
  const std::string token = trimmed(error.GetToken());
  switch (error.GetCode()) {
    case mu::ecUNEXPECTED_EOF: return "the expression ends too early";
    case mu::ecMISSING_PARENS: return "a closing parenthesis is missing";
    case mu::ecTOO_FEW_PARAMS: return "too few arguments for the function '" + token + "'";
    case mu::ecTOO_MANY_PARAMS: return "too many arguments for the function '" + token + "'";
    case mu::ecMISSING_ELSE_CLAUSE: return "'?' needs its ':'";
    case mu::ecEXPRESSION_TOO_LONG: return "the expression is too long";
    case mu::ecSTR_RESULT: return "texts are not allowed in an expression";
    default:
      return quoted(token) + " is not expected at character " + std::to_string(error.GetPos() + 1) +
             " of the expression";
  }
}

}  // namespace

CompiledFormula::CompiledFormula(const std::string& formula, const NamedValues* names,
                                 std::string& fault) {
  try {
    define_names(names);
    fault = trimmed(formula).empty() ? "the expression is empty" : fault_in_names(formula);
    if (fault.empty()) fault = compile(formula);
  } catch (const mu::ParserError& error) {
    fault = sentence(error);
  }
}

std::vector<std::string> names_of_formulas() {
  std::string fault;
  return CompiledFormula("0", nullptr, fault).names();
}

std::vector<std::string> CompiledFormula::names() const {
  std::vector<std::string> result = keys(parser_.GetVar());
  for (const auto& others : {keys(parser_.GetConst()), keys(parser_.GetFunDef())})
    result.insert(result.end(), others.begin(), others.end());
  std::sort(result.begin(), result.end());
  return result;
}

bool CompiledFormula::uses_any(const std::string& variables) const {
  return used_.find_first_of(variables) != std::string::npos;
}

void CompiledFormula::define_names(const NamedValues* names) {
  parser_.DefineVar("t", &point_.t);
  parser_.DefineVar("x", &point_.x);
  parser_.DefineVar("y", &point_.y);
  parser_.DefineVar("z", &point_.z);
  parser_.DefineVar("X", &point_.X);
  parser_.DefineVar("Y", &point_.Y);
  parser_.DefineVar("Z", &point_.Z);
  parser_.ClearConst();
  parser_.DefineConst("pi", pi);
  parser_.DefineFun("ramp", ramp);
  parser_.DefineFun("ramp_distance", ramp_distance);
  for (std::size_t i = 0; names != nullptr && i < names->size(); ++i)
    parser_.DefineConst((*names)[i].name, (*names)[i].value);
}

// What muParser would accept or explain badly: names, numbers, assignments.
std::string CompiledFormula::fault_in_names(const std::string& formula) const {
  const auto functions = keys(parser_.GetFunDef());
  auto names = keys(parser_.GetVar());
  for (const std::string& constant : keys(parser_.GetConst()))
    names.push_back(constant);
  for (std::size_t i = 0; i < formula.size();) {
    const std::size_t begin = i;
    const char c = formula[i];
    if (is_digit(c) || c == '.') {
      i = end_of_number(formula, begin);
      const std::string number = formula.substr(begin, i - begin);
      double value = 0;
      const std::string fault = read_number(number, value);
      if (!fault.empty()) return quoted(number) + ": " + fault;
      if (i < formula.size() && is_letter(formula[i])) {
        while (i < formula.size() && is_in_name(formula[i]))
          ++i;
        const std::string rest = formula.substr(begin + number.size(), i - begin - number.size());
        return quoted(rest) + " after the number " + number + " is not understood";
      }
    } else if (is_letter(c)) {
      while (i < formula.size() && is_in_name(formula[i]))
        ++i;
      const std::string name = formula.substr(begin, i - begin);
      const std::size_t next = formula.find_first_not_of(" \t", i);
      const bool called = next != std::string::npos && formula[next] == '(';
      if (called && !contains(functions, name))
        return "there is no function " + quoted(name) + "; functions are " + listed(functions) +
               did_you_mean(name, functions);
      if (!called && contains(functions, name))
        return "the function " + quoted(name) + " needs its arguments in parentheses";
      if (!called && !contains(names, name))
        return "the name " + quoted(name) + " is not known; names are " + listed(names) +
               did_you_mean(name, names);
    } else {
      const bool compares = i + 1 < formula.size() && formula[i + 1] == '=';
      if (c == '=' && !compares) return "'=' is not allowed; == compares";
      i += compares && std::string("=!<>").find(c) != std::string::npos ? 2 : 1;
    }
  }
  return "";
}

std::string CompiledFormula::compile(const std::string& formula) {
  parser_.SetExpr(formula);
  for (const auto& variable : parser_.GetUsedVar())
    used_ += variable.first;
  int results = 0;
  parser_.Eval(results);
  if (results != 1)
    return "one value is needed, but ',' makes it " + std::to_string(results) +
           "; components are separated by ';'";
  return "";
}

}  // namespace hawser
