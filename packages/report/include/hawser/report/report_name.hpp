#pragma once
#include <algorithm>
#include <cctype>
#include <string>

#include "hawser/deck/diagnostics.hpp"

namespace hawser {

/// For Spec::check(): the name becomes part of a table's columns and of the names in summary.json.
template <class P>
void check_report_name(const P& p, const Location& where, Diagnostics& diagnostics) {
  const bool fits = std::all_of(p.name.begin(), p.name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
  if (!fits)
    diagnostics.error(where, "the name '" + p.name +
                                 "' becomes a column of history.csv; letters, digits, _ and - are "
                                 "allowed");
}

}  // namespace hawser
