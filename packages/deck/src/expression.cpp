#include "hawser/deck/expression.hpp"

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/deck/value.hpp"
#include "src/parse_formula.hpp"
#include "src/refuse_value.hpp"

namespace hawser {

Expression::Expression(double value) : value_(value), text_(write_value(value)) {}

Expression::Expression(const std::string& formula, const Location& location) {
  const std::string fault = compile(formula, location, nullptr, *this);
  if (!fault.empty()) throw DeckError(location.text() + ": " + fault);
}

std::string Expression::compile(const std::string& formula, const Location& location,
                                const NamedValues* names, Expression& result) {
  auto compiled = std::make_shared<Formula>();
  std::string fault = parse_formula(formula, names, *compiled);
  if (!fault.empty()) return fault;
  result = Expression();
  result.text_ = formula;
  result.location_ = location;
  if (!compiled->uses_any("xyzXYZt")) {
    result.value_ = compiled->value({});
    if (!std::isfinite(result.value_)) return "its value is not finite";
  } else {
    result.formula_ = std::move(compiled);
  }
  return "";
}

Expression Expression::constant(double value, const std::optional<Unit>& unit,
                                const Location& location) {
  Expression result(value);
  result.unit_ = unit;
  result.location_ = location;
  return result;
}

double Expression::operator()(const SpaceTime& point) const {
  return formula_ ? finite(formula_->value(point), "expression", point) : value_;
}

double Expression::time_derivative(const SpaceTime& point) const {
  if (!depends_on_time()) return 0;
  return finite(formula_->value_and_slopes(point).slope[3], "derivative in t of the expression",
                point);
}

Expression::Tangent Expression::tangent(const SpaceTime& point) const {
  if (!depends_on_moved_position()) return {(*this)(point), {}};
  const Dual found = formula_->value_and_slopes(point);
  return {finite(found.value, "expression", point),
          {finite(found.slope[0], "derivative in x of the expression", point),
           finite(found.slope[1], "derivative in y of the expression", point),
           finite(found.slope[2], "derivative in z of the expression", point)}};
}

double Expression::finite(double number, const char* what, const SpaceTime& point) const {
  if (!std::isfinite(number)) refuse_value(number, what, *this, point, "");
  return number;
}

bool Expression::depends_on_time() const { return formula_ && formula_->uses_any("t"); }
bool Expression::depends_on_space() const { return formula_ && formula_->uses_any("xyzXYZ"); }
bool Expression::depends_on_moved_position() const { return formula_ && formula_->uses_any("xyz"); }

}  // namespace hawser
