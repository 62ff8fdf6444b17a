#pragma once
#include <string>

namespace hawser::program {

/// Writes a plug-in of that name that builds and is tested into a new folder of that name. Error of
/// the command line when the name cannot be one, OutputError when the folder is there or cannot be
/// written.
void write_plugin(const std::string& name);

}  // namespace hawser::program
