#pragma once
// The readers, one per format.
#include "hawser/navigation/navigation_line.hpp"

namespace hawser {

NavigationLine read_csv_line(const std::string& text, const std::string& file,
                             Diagnostics& diagnostics);

/// Whether it begins with a header record: H and four digits.
bool is_p190(const std::string& text);
NavigationLine read_p190(const std::string& text, const std::string& file,
                         const NavigationOptions& options, Diagnostics& diagnostics);

}  // namespace hawser
