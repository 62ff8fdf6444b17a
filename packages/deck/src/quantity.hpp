#pragma once
// One value as text: a number, a number and its unit, or a formula of the deck's parameters.
#include <optional>
#include <string>
#include <vector>

#include "hawser/deck/value.hpp"

namespace hawser {

/// The kinds of text that stand for one value.
enum class ValueKind { number, with_unit, formula };
ValueKind kind_of(const std::string& text);

/// Sets `value`, in the reading's unit, and returns "", or returns what is wrong. Ranges are not
/// checked here.
std::string read_quantity(const Reading& reading, const std::string& text, double& value);

/// The same, where formulas may depend on place and time.
std::string read_expression(const Reading& reading, const std::string& text, Expression& value);
/// The same, where they may speak of fields, too.
std::string read_expression(const Reading& reading, const std::string& text,
                            FieldExpression& value);

/// Splits a list at ';', or, where it holds nothing but numbers and units, at the blanks between
/// values: "0; 2*dt", "0 -420", "0 m -2 km". A unit that stands once, at the end, is for all.
std::vector<std::string> split_values(const std::string& text);

}  // namespace hawser
