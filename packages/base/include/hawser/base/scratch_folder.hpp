#pragma once
#include <string>

#include "hawser/base/communicator.hpp"

namespace hawser {

/// A folder that is gone, with what is in it, when this is. Collective; OutputError on all ranks.
class ScratchFolder {
 public:
  explicit ScratchFolder(const Communicator& communicator);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const { return path_; }  ///< rank 0's

 private:
  Communicator communicator_;
  std::string path_;
};

}  // namespace hawser
