#include "hawser/deck/expression.hpp"

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/deck/value.hpp"
#include "src/formula.hpp"

namespace hawser {

struct Expression::Formula : CompiledFormula {
  using CompiledFormula::CompiledFormula;
};

Expression::Expression(double value) : value_(value), text_(write_value(value)) {}

Expression::Expression(const std::string& formula, const Location& location) {
  const std::string fault = compile(formula, location, nullptr, *this);
  if (!fault.empty()) throw DeckError(location.text() + ": " + fault);
}

std::string Expression::compile(const std::string& formula, const Location& location,
                                const NamedValues* names, Expression& result) {
  std::string fault;
  auto compiled = std::make_shared<Formula>(formula, names, fault);
  if (!fault.empty()) return fault;
  result = Expression();
  result.text_ = formula;
  result.location_ = location;
  if (!compiled->uses_any("xyzXYZt")) {
    result.value_ = compiled->evaluate({});
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
  return formula_ ? evaluate(point) : value_;
}

double Expression::evaluate(const SpaceTime& point) const {
  const double value = formula_->evaluate(point);
  if (std::isfinite(value)) return value;
  std::string where = "x = " + write_value(point.x) + ", y = " + write_value(point.y);
  if (point.z != 0) where += ", z = " + write_value(point.z);
  throw SolveError(location_.text() + ": the expression '" + text_ + "' is " +
                   (std::isnan(value) ? "not a number" : "infinite") + " at " + where +
                   " m, t = " + write_value(point.t) + " s");
}

double Expression::derivative_step(double value) { return 6e-6 * std::fmax(1.0, std::fabs(value)); }

double Expression::derivative(const SpaceTime& point, double SpaceTime::*variable) const {
  const double step = derivative_step(point.*variable);
  SpaceTime ahead = point, behind = point;
  ahead.*variable += step;
  behind.*variable -= step;
  // At the edge of the formula's domain, such as sqrt(t) at the start, from the inner side only.
  if (!std::isfinite(formula_->evaluate(behind))) behind = point;
  if (!std::isfinite(formula_->evaluate(ahead))) ahead = point;
  // The step that was really made, after rounding.
  return (evaluate(ahead) - evaluate(behind)) / (ahead.*variable - behind.*variable);
}

double Expression::time_derivative(const SpaceTime& point) const {
  return depends_on_time() ? derivative(point, &SpaceTime::t) : 0;
}

std::array<double, 3> Expression::gradient(const SpaceTime& point) const {
  const auto along = [&](const char* name, double SpaceTime::*variable) {
    return formula_ && formula_->uses_any(name) ? derivative(point, variable) : 0;
  };
  return {along("x", &SpaceTime::x), along("y", &SpaceTime::y), along("z", &SpaceTime::z)};
}

bool Expression::depends_on_time() const { return formula_ && formula_->uses_any("t"); }
bool Expression::depends_on_space() const { return formula_ && formula_->uses_any("xyzXYZ"); }
bool Expression::depends_on_moved_position() const { return formula_ && formula_->uses_any("xyz"); }

}  // namespace hawser
