#pragma once
#include <filesystem>

namespace hawser {

/// The folder that holds bin, share and, at some depth, the libraries: an installation's prefix, or
/// the build folder. Found from where this library lies, whoever uses it.
std::filesystem::path installation_folder();

}  // namespace hawser
