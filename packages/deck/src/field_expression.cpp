#include "hawser/deck/field_expression.hpp"

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/deck/value.hpp"
#include "src/parse_formula.hpp"
#include "src/refuse_value.hpp"

namespace hawser {

struct FieldExpression::Compiled {
  Formula formula;
  FieldNames fields;
  std::vector<std::string> all_parameters;
};

std::string FieldReference::name() const {
  return of_vector ? field + "_" + static_cast<char>('x' + component) : field;
}

std::string FieldReference::text() const {
  if (along < 0) return name();
  return std::string("d") + static_cast<char>('x' + along) + "(" + name() + ")";
}

FieldExpression::FieldExpression(double value) : value_(value), text_(write_value(value)) {}

FieldExpression::FieldExpression(const std::string& formula, const Location& location) {
  const std::string fault = compile(formula, location, nullptr, *this);
  if (!fault.empty()) throw DeckError(location.text() + ": " + fault);
}

std::string FieldExpression::compile(const std::string& formula, const Location& location,
                                     const NamedValues* names, FieldExpression& result) {
  auto compiled = std::make_shared<Compiled>();
  std::string fault = parse_formula(formula, names, compiled->formula, &compiled->fields);
  if (!fault.empty()) return fault;
  for (std::size_t i = 0; names != nullptr && i < names->size(); ++i)
    compiled->all_parameters.push_back((*names)[i].name);
  result = FieldExpression();
  result.text_ = formula;
  result.location_ = location;
  result.parameters_ = compiled->fields.parameters;
  if (compiled->fields.references.empty() && !compiled->formula.uses_any("xyzXYZt")) {
    result.value_ = compiled->formula.value({});
    if (!std::isfinite(result.value_)) return "its value is not finite";
  } else {
    result.compiled_ = std::move(compiled);
  }
  return "";
}

FieldExpression FieldExpression::constant(double value, const std::optional<Unit>& unit,
                                          const Location& location) {
  FieldExpression result(value);
  result.unit_ = unit;
  result.location_ = location;
  return result;
}

const std::vector<FieldReference>& FieldExpression::references() const {
  static const std::vector<FieldReference> none;
  return compiled_ ? compiled_->fields.references : none;
}

std::vector<std::string> FieldExpression::names_beside(std::vector<std::string> fields) const {
  for (const char* const name : {"X", "Y", "Z", "t", "x", "y", "z", "pi"})
    fields.emplace_back(name);
  if (compiled_)
    fields.insert(fields.end(), compiled_->all_parameters.begin(), compiled_->all_parameters.end());
  return fields;
}

double FieldExpression::operator()(const SpaceTime& point, const double* references) const {
  if (!compiled_) return value_;
  return finite(compiled_->formula.value(point, references), "expression", point, references);
}

double FieldExpression::tangent(const SpaceTime& point, const double* references,
                                double* slopes) const {
  const int count = static_cast<int>(this->references().size());
  for (int k = 0; k < 3 + count; ++k)
    slopes[k] = 0;
  const bool moves = depends_on_moved_position();
  if (!moves && count == 0) return (*this)(point, references);
  const Formula& formula = compiled_->formula;
  double value = 0;
  // As many directions at once as a Dual has: place and time, then the references.
  for (int first = moves ? 0 : Dual::directions; first < Dual::directions + count;
       first += Dual::directions) {
    const Dual found = formula.value_and_slopes(point, references, first);
    value = finite(found.value, "expression", point, references);
    const bool place = first == 0;
    for (int k = 0; k < Dual::directions; ++k) {
      const int reference = first + k - Dual::directions;
      if (place ? k > 2 : reference >= count) break;
      const int slope = place ? k : 3 + reference;
      if (!std::isfinite(found.slope[k]))
        finite(found.slope[k],
               "derivative by " +
                   (place ? std::string(1, static_cast<char>('x' + k))
                          : this->references()[static_cast<std::size_t>(reference)].text()) +
                   " of the expression",
               point, references);
      slopes[slope] = found.slope[k];
    }
  }
  return value;
}

int FieldExpression::degree(int place, const std::vector<int>& references) const {
  return compiled_ ? compiled_->formula.degree(place, references) : 0;
}

double FieldExpression::finite(double number, const std::string& what, const SpaceTime& point,
                               const double* references) const {
  if (std::isfinite(number)) return number;
  std::string more;
  for (std::size_t i = 0; i < this->references().size(); ++i)
    more += (i == 0 ? ", where " : ", ") + this->references()[i].text() + " = " +
            write_value(references[i]);
  refuse_value(number, what, *this, point, more);
}

bool FieldExpression::depends_on_time() const {
  return compiled_ && compiled_->formula.uses_any("t");
}
bool FieldExpression::depends_on_space() const {
  return compiled_ && compiled_->formula.uses_any("xyzXYZ");
}
bool FieldExpression::depends_on_moved_position() const {
  return compiled_ && compiled_->formula.uses_any("xyz");
}

}  // namespace hawser
