#pragma once
// A formula compiled by muParser.
#include <muParser.h>

#include <string>
#include <vector>

#include "hawser/deck/expression.hpp"

namespace hawser {

/// Names that a parameter cannot have: variables, constants, functions. Sorted.
std::vector<std::string> names_of_formulas();

class CompiledFormula {
 public:
  /// `fault` receives what is wrong with the formula, or "". `names` may be null.
  CompiledFormula(const std::string& formula, const NamedValues* names, std::string& fault);
  CompiledFormula(const CompiledFormula&) = delete;  // the parser holds addresses of point_
  CompiledFormula& operator=(const CompiledFormula&) = delete;

  double evaluate(const SpaceTime& point) const {
    point_ = point;
    return parser_.Eval();
  }
  std::vector<std::string> names() const;             ///< of variables, constants and functions
  bool uses_any(const std::string& variables) const;  ///< one letter each

 private:
  void define_names(const NamedValues* names);
  std::string fault_in_names(const std::string& formula) const;
  std::string compile(const std::string& formula);

  mutable SpaceTime point_;
  mu::Parser parser_;
  std::string used_;  // the variables, one letter each
};

}  // namespace hawser
