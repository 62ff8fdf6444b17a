#include "figure_script.hpp"

#include <filesystem>

#include "hawser/base/error.hpp"

namespace hawser::program {

std::string figure_script(const std::string& name) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  for (const std::filesystem::path& folder :
       {program.parent_path().parent_path() / "share/hawser/figures",
        std::filesystem::path(HAWSER_FIGURES)})
    if (std::filesystem::exists(folder / name)) return (folder / name).string();
  throw OutputError("the script " + name + " is not installed beside " + program.string());
}

}  // namespace hawser::program
