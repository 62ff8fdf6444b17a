#pragma once
#include <string>

#include "src/formula.hpp"

namespace hawser {

/// Reads `text` into `result` and returns "", or returns what is wrong. `names` may be null.
std::string parse_formula(const std::string& text, const NamedValues* names, Formula& result);

}  // namespace hawser
