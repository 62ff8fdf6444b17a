#pragma once
// A formula as a program in postfix order: "2*x + t" is 2, x, *, t, +. It is evaluated on numbers,
// or on numbers with their derivatives (forward differentiation), by the same program.
#include <string>
#include <vector>

#include "hawser/deck/expression.hpp"
#include "src/dual.hpp"
#include "src/formula_functions.hpp"

namespace hawser {

/// Evaluations change nothing and allocate nothing: any number of threads may share one.
class Formula {
 public:
  static constexpr int deepest = 64;  ///< values that wait for their operation at once

  enum class Operation {
    number,
    variable,
    reference,  ///< to a value that the caller gives, `number` in a FieldExpression's list
    negate,
    add,
    subtract,
    multiply,
    divide,
    whole_power,  ///< to the exponent `number`, a small whole one
    less,
    greater,
    at_most,
    at_least,
    equal,
    unequal,
    both,
    either,
    choose,  ///< of a condition, the value if it holds, the value if not
    function_of_one,
    function
  };
  struct Variable {
    char name;
    double SpaceTime::*member;
    int direction;  ///< of all that there are derivatives by; -1: it is none of them
  };
  struct Step {
    Operation operation;
    int operands = 0;  ///< that it takes off the stack, to put one value there
    double number = 0;
    const Variable* variable = nullptr;
    const FormulaFunction* function = nullptr;
  };

  /// What can be worked out at once, is. The result must not be evaluated when depth() > deepest.
  void append(const Step& step);
  /// The base is there, the exponent too, unless it is known: small whole ones are multiplied out.
  void append_power();
  int depth() const { return depth_; }

  double value(const SpaceTime& at, const double* references = nullptr) const {
    return run<double>(at, references, 0);
  }
  /// A Dual's directions, one after another, from `first` on of: x, y, z, t, reference 0, 1, ...
  Dual value_and_slopes(const SpaceTime& at, const double* references = nullptr,
                        int first = 0) const {
    return run<Dual>(at, references, first);
  }
  bool uses_any(const std::string& variables) const;  ///< one letter each
  /// Of the polynomial that it is where places have the degree `place` and references those given;
  /// -1 where it is none.
  int degree(int place, const std::vector<int>& references) const;

 private:
  template <class T>
  T run(const SpaceTime& at, const double* references, int first) const;

  std::vector<Step> steps_;
  std::string used_;  // variables, a letter each
  int waiting_ = 0, depth_ = 0;
};

}  // namespace hawser
