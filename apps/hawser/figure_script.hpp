#pragma once
#include <string>

namespace hawser::program {

/// A script that draws: installed beside the program, or of the tree it was built in. OutputError.
std::string figure_script(const std::string& name);

}  // namespace hawser::program
