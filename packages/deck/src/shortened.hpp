#pragma once
#include <string>

namespace hawser {

/// On one line, and cut to about `longest` bytes.
std::string shortened(const std::string& given, std::size_t longest);

}  // namespace hawser
