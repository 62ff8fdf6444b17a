#pragma once
// The words of a formula, with what they stand for.
#include <map>
#include <string>
#include <vector>

#include "src/formula.hpp"

namespace hawser {

/// Names that a parameter cannot have: variables, constants, functions. Sorted.
std::vector<std::string> names_of_formulas();

/// What is wrong with a formula.
struct FormulaFault {
  std::string sentence;
};

struct FormulaToken {
  enum class Kind { end, number, variable, function, symbol };
  Kind kind = Kind::end;
  std::string text;
  std::size_t position = 0;  ///< characters before it
  double number = 0;         ///< a named constant's, too
  const Formula::Variable* variable = nullptr;
  const FormulaFunction* function = nullptr;
};

/// Throws FormulaFault at names that are not known and at numbers that are none.
class FormulaTokens {
 public:
  /// `names` may be null.
  FormulaTokens(const std::string& text, const NamedValues* names);

  const FormulaToken& now() const { return now_; }
  bool at(const char* symbol) const {
    return now_.kind == FormulaToken::Kind::symbol && now_.text == symbol;
  }
  void next();
  [[noreturn]] void refuse() const;  ///< the token where it stands

 private:
  void read_number();
  void read_name();
  std::string take_name();
  bool followed_by_parenthesis() const;

  std::string text_;
  std::size_t cursor_ = 0;
  std::map<std::string, double> constants_;
  FormulaToken now_;
};

}  // namespace hawser
