#pragma once
// Numbers, strictly: the whole text is one finite number or there is a reason why not.
#include <string>
#include <vector>

namespace hawser {

/// Sets `value` and returns "", or returns what is wrong.
std::string read_number(const std::string& text, double& value);
std::string read_whole_number(const std::string& text, int& value);

std::vector<std::string> split_at_blanks(const std::string& text);
std::vector<std::string> split_at(const std::string& text, char separator);  ///< parts are trimmed

}  // namespace hawser
