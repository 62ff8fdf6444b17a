#pragma once
// The functions of decks' formulas, each with its derivatives by its arguments.
#include <string>
#include <vector>

namespace hawser {

struct FormulaFunction {
  std::string name;
  int least, most;  ///< how many arguments
  // Of one argument u: the value f(u), and the derivative from u and f.
  double (*value)(double u);
  double (*slope)(double u, double f);
  // Of several, else: u[count]; `slopes`[count], unless null, receives the derivatives by them.
  double (*of_several)(const double* u, int count, double* slopes);
};

/// Sorted by name.
const std::vector<FormulaFunction>& formula_functions();

/// u^v.
extern const FormulaFunction power_function;

}  // namespace hawser
