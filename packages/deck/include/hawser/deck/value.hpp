#pragma once
// How the text of an attribute becomes a C++ value, strictly: a value is read whole or it is an
// error. Numbers may carry a unit or be formulas of the deck's parameters; they arrive in the unit
// of the attribute's declaration.
//
// Each value type has three functions: read_value, write_value, type_name. A type of one's own
// joins in by overloading them in its namespace.
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "hawser/base/domain.hpp"
#include "hawser/deck/expression.hpp"
#include "hawser/deck/field_expression.hpp"
#include "hawser/deck/location.hpp"
#include "hawser/deck/rules.hpp"

namespace hawser {

/// Everything known about one value while it is read.
struct Reading {
  std::string text;  ///< without blanks at either end, not empty
  Location location;
  std::string unit;
  const Rules& rules;
  const NamedValues* names = nullptr;  ///< the deck's parameters; may be null
};

/// On success sets `value` and returns ""; else returns what is wrong and what is allowed, a clause
/// that follows "attribute 'a' of <b> is 'c': ".
std::string read_value(const Reading& reading, double& value);
std::string read_value(const Reading& reading, int& value);
std::string read_value(const Reading& reading, bool& value);
std::string read_value(const Reading& reading, std::string& value);
std::string read_value(const Reading& reading, Expression& value);
std::string read_value(const Reading& reading, std::vector<double>& value);
std::string read_value(const Reading& reading, std::vector<std::string>& value);
std::string read_value(const Reading& reading, Expressions& value);
std::string read_value(const Reading& reading, FieldExpression& value);
std::string read_value(const Reading& reading, FieldExpressions& value);
std::string read_value(const Reading& reading, Domain& value);  ///< one or several regions

/// Text that reads back as the same value; "" for an absent one.
std::string write_value(double value);
std::string write_value(int value);
std::string write_value(bool value);
std::string write_value(const std::string& value);
std::string write_value(const Expression& value);
std::string write_value(const std::vector<double>& value);
std::string write_value(const std::vector<std::string>& value);
std::string write_value(const Expressions& value);
std::string write_value(const FieldExpression& value);
std::string write_value(const FieldExpressions& value);
std::string write_value(const Domain& value);

/// What the reference manual calls the type.
std::string type_name(const double&);
std::string type_name(const int&);
std::string type_name(const bool&);
std::string type_name(const std::string&);
std::string type_name(const Expression&);
std::string type_name(const std::vector<double>&);
std::string type_name(const std::vector<std::string>&);
std::string type_name(const Expressions&);
std::string type_name(const FieldExpression&);
std::string type_name(const FieldExpressions&);
std::string type_name(const Domain&);

/// Located<T>: the value with its place.
template <class T>
std::string read_value(const Reading& reading, Located<T>& value) {
  value.location = reading.location;
  return read_value(reading, value.value);
}
template <class T>
std::string write_value(const Located<T>& value) {
  return write_value(value.value);
}
template <class T>
std::string type_name(const Located<T>& value) {
  return type_name(value.value);
}

/// std::optional<T>: may be left out, and has no default.
template <class T>
std::string read_value(const Reading& reading, std::optional<T>& value) {
  return read_value(reading, value.emplace());
}
template <class T>
std::string write_value(const std::optional<T>& value) {
  return value ? write_value(*value) : std::string();
}
template <class T>
std::string type_name(const std::optional<T>&) {
  return type_name(T{});
}

/// Types that are physical quantities: their attributes must name a unit ("1" when there is none).
template <class T>
struct IsQuantity : std::false_type {};
template <>
struct IsQuantity<double> : std::true_type {};
template <>
struct IsQuantity<Expression> : std::true_type {};
template <>
struct IsQuantity<std::vector<double>> : std::true_type {};
template <>
struct IsQuantity<Expressions> : std::true_type {};
template <>
struct IsQuantity<FieldExpression> : std::true_type {};
template <>
struct IsQuantity<FieldExpressions> : std::true_type {};
template <class T>
struct IsQuantity<Located<T>> : IsQuantity<T> {};
template <class T>
struct IsQuantity<std::optional<T>> : IsQuantity<T> {};

/// Types made of numbers, which may be written with units or as formulas.
template <class T>
struct IsNumeric : IsQuantity<T> {};
template <>
struct IsNumeric<int> : std::true_type {};
template <class T>
struct IsNumeric<Located<T>> : IsNumeric<T> {};
template <class T>
struct IsNumeric<std::optional<T>> : IsNumeric<T> {};

}  // namespace hawser
