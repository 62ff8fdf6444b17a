#include "hawser/base/scratch_folder.hpp"

#include <cstdlib>
#include <filesystem>

#include "hawser/base/error.hpp"

namespace hawser {

ScratchFolder::ScratchFolder(const Communicator& communicator) : communicator_(communicator) {
  communicator_.on_root([&] {
    std::error_code none;
    path_ = (std::filesystem::temp_directory_path(none) / "hawser-XXXXXX").string();
    if (mkdtemp(path_.data()) == nullptr) throw OutputError("cannot make the folder " + path_);
  });
  path_ = communicator_.broadcast(path_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code none;
  if (communicator_.is_root()) std::filesystem::remove_all(path_, none);
}

}  // namespace hawser
