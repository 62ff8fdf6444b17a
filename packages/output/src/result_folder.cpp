#include "hawser/output/result_folder.hpp"

#include <filesystem>

#include "hawser/base/error.hpp"
#include "src/files.hpp"
#include "src/run_lock.hpp"

namespace hawser {

namespace {

/// In the order in which a run makes them.
constexpr const char* history = "history.csv";
constexpr const char* checkpoint = "checkpoint.h5";
constexpr const char* previous = "checkpoint.previous.h5";
constexpr const char* summary = "summary.json";

void refuse_results(const ResultFolder& folder) {
  const auto holds = [&](const char* name) {
    std::error_code none;
    return std::filesystem::exists(folder.file(name), none);
  };
  if (holds(summary))
    throw OutputError(folder.path() +
                      " holds the results of another run (summary.json); choose another folder, or "
                      "--force to write over them");
  if (holds(checkpoint) || holds(previous))
    throw OutputError(folder.path() + " holds an unfinished run; go on with: hawser restart " +
                      folder.file(checkpoint) +
                      "; or choose another folder, or --force to begin again");
  if (holds(history))
    throw OutputError(
        folder.path() +
        " holds an unfinished run, without a checkpoint to go on from; choose another "
        "folder, or --force to begin again");
}

}  // namespace

ResultFolder::ResultFolder(const Communicator& communicator, std::string path,
                           ExistingResults existing)
    : communicator_(communicator), path_(std::move(path)) {
  communicator_.on_root([&] {
    std::error_code error;
    std::filesystem::create_directories(path_, error);
    if (error) throw_cannot("make the folder", path_, error.value());
    const std::string trial = file("writable");
    try_room(trial, 0);
    std::filesystem::remove(trial, error);
    lock_ = std::make_unique<RunLock>(path_);
    if (existing == ExistingResults::keep) refuse_results(*this);
    // From here on the folder is that of an unfinished run.
    std::filesystem::remove(file(summary), error);
    if (existing == ExistingResults::replace)
      for (const char* const name : {checkpoint, previous})
        std::filesystem::remove(file(name), error);
  });
}

ResultFolder::~ResultFolder() = default;

void ResultFolder::write(const std::string& name, const std::string& text) const {
  communicator_.on_root([&] { write_atomically(file(name), text); });
}

}  // namespace hawser
