#pragma once
// A formula compiled by muParser.
#include <muParser.h>

#include <string>

#include "hawser/deck/expression.hpp"

namespace hawser {

class CompiledFormula {
 public:
  /// `fault` receives what is wrong with the formula, or "".
  CompiledFormula(const std::string& formula, std::string& fault);
  CompiledFormula(const CompiledFormula&) = delete;  // the parser holds addresses of point_
  CompiledFormula& operator=(const CompiledFormula&) = delete;

  double evaluate(const SpaceTime& point) const {
    point_ = point;
    return parser_.Eval();
  }
  bool uses_any(const std::string& variables) const;  ///< one letter each

 private:
  void define_names();
  std::string fault_in_names(const std::string& formula) const;
  std::string compile(const std::string& formula);

  mutable SpaceTime point_;
  mu::Parser parser_;
  std::string used_;  // the variables, one letter each
};

}  // namespace hawser
