#pragma once
#include <string>

#include "src/formula.hpp"
#include "src/formula_tokens.hpp"

namespace hawser {

/// Reads `text` into `result` and returns "", or returns what is wrong. `names` may be null; so may
/// `fields`, and then every name must be known.
std::string parse_formula(const std::string& text, const NamedValues* names, Formula& result,
                          FieldNames* fields = nullptr);

}  // namespace hawser
