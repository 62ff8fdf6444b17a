#include "figure_script.hpp"

#include <filesystem>

#include "hawser/base/error.hpp"
#include "hawser/base/installation.hpp"

namespace hawser::program {

std::string figure_script(const std::string& name) {
  for (const std::filesystem::path& folder :
       {installation_folder() / "share/hawser/figures", std::filesystem::path(HAWSER_FIGURES)})
    if (std::filesystem::exists(folder / name)) return (folder / name).string();
  throw OutputError("the script " + name + " is not installed in " +
                    installation_folder().string());
}

}  // namespace hawser::program
