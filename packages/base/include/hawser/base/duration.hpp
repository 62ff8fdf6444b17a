#pragma once
#include <string>

namespace hawser {

/// Wall time in s from "5h50m", "90m", "1d12h", "45s" or a plain number of seconds. Error (usage)
/// for anything else, and for no time at all.
double read_duration(const std::string& text);

}  // namespace hawser
