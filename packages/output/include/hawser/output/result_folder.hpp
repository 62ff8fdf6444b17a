#pragma once
// The folder that a run writes into.
#include <memory>
#include <string>

#include "hawser/base/communicator.hpp"

namespace hawser {

/// What to do about a run that the folder holds already.
enum class ExistingResults {
  keep,     ///< refuse the folder
  replace,  ///< what this run does not write over must not be taken for its own: it goes
  go_on     ///< this run continues that one
};

class RunLock;

class ResultFolder {
 public:
  /// Makes the folder and its parents, checks that it can be written, and locks it: no other run
  /// has it before this is gone. Collective; OutputError on all ranks.
  ResultFolder(const Communicator& communicator, std::string path,
               ExistingResults existing = ExistingResults::keep);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  /// A small text file, all or nothing; rank 0's text counts. Collective; OutputError on all ranks.
  void write(const std::string& name, const std::string& text) const;

 private:
  Communicator communicator_;
  std::string path_;
  std::unique_ptr<RunLock> lock_;  // rank 0's
};

}  // namespace hawser
