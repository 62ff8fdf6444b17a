#pragma once
// The folder that a run writes into.
#include <string>

#include "hawser/base/communicator.hpp"

namespace hawser {

class ResultFolder {
 public:
  /// Makes the folder and its parents and checks that it can be written. A folder that holds a
  /// finished run (a summary.json) is refused unless `force`. Collective; OutputError on all ranks.
  ResultFolder(const Communicator& communicator, std::string path, bool force = false);

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  /// A small text file, all or nothing; rank 0's text counts. Collective; OutputError on all ranks.
  void write(const std::string& name, const std::string& text) const;

 private:
  Communicator communicator_;
  std::string path_;
};

}  // namespace hawser
