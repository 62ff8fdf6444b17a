#pragma once
// Numbers, strictly: the whole text is one finite number or there is a reason why not.
#include <string>

namespace hawser {

/// Sets `value` and returns "", or returns what is wrong.
std::string read_number(const std::string& text, double& value);
std::string read_whole_number(const std::string& text, int& value);

}  // namespace hawser
