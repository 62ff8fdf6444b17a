#include "hawser/base/installation.hpp"

#include <dlfcn.h>

namespace hawser {

std::filesystem::path installation_folder() {
  Dl_info library = {};
  dladdr(reinterpret_cast<void*>(&installation_folder), &library);
  std::error_code none;
  auto folder = std::filesystem::canonical(library.dli_fname, none).parent_path();
  while (folder.has_relative_path() && !std::filesystem::is_directory(folder / "bin", none))
    folder = folder.parent_path();
  return folder;
}

}  // namespace hawser
