#pragma once
// The words of a formula, with what they stand for.
#include <map>
#include <string>
#include <vector>

#include "hawser/deck/field_expression.hpp"
#include "src/formula.hpp"

namespace hawser {

/// Names that a parameter cannot have: variables, constants, functions. Sorted.
std::vector<std::string> names_of_formulas();

/// What a formula says beside variables and functions, where it may speak of fields.
struct FieldNames {
  std::vector<FieldReference> references;
  std::vector<std::string> parameters;  ///< of the deck that it uses

  /// Of the field or component `name`, or of its derivative; a new one only when there is none yet.
  int index(const std::string& name, int along);
};

/// What is wrong with a formula.
struct FormulaFault {
  std::string sentence;
};

struct FormulaToken {
  enum class Kind { end, number, variable, function, field, derivative, symbol };
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
  /// `names` may be null. With `fields`, names that are not known are those of fields, and dx, dy
  /// and dz are derivatives.
  FormulaTokens(const std::string& text, const NamedValues* names, FieldNames* fields = nullptr);

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
  FieldNames* fields_;
  FormulaToken now_;
};

}  // namespace hawser
