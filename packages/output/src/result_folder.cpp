#include "hawser/output/result_folder.hpp"

#include <filesystem>

#include "hawser/base/error.hpp"
#include "src/files.hpp"

namespace hawser {

ResultFolder::ResultFolder(const Communicator& communicator, std::string path, bool force)
    : communicator_(communicator), path_(std::move(path)) {
  communicator_.on_root([&] {
    std::error_code error;
    std::filesystem::create_directories(path_, error);
    if (error) throw_cannot("make the folder", path_, error.value());
    const std::string trial = file("writable");
    try_room(trial, 0);
    std::filesystem::remove(trial, error);
    const std::string summary = file("summary.json");
    if (!std::filesystem::exists(summary, error)) return;
    if (!force) {
      throw OutputError(path_ +
                        " holds the results of another run (summary.json); choose another " +
                        "folder, or --force to write over them");
    }
    // From here on the folder is that of an unfinished run.
    std::filesystem::remove(summary, error);
  });
}

void ResultFolder::write(const std::string& name, const std::string& text) const {
  communicator_.on_root([&] { write_atomically(file(name), text); });
}

}  // namespace hawser
