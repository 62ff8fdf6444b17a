#pragma once
// The files that a run reads: decks, tables, meshes. What was read is kept, so that a checkpoint
// can hold it and a restarted run reads the very same again, whatever has become of the files.
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"

namespace hawser {

struct InputFile {
  std::string path{};  ///< absolute; empty for a text that never was a file
  std::string text{};
};

/// By the names that decks give them, or are given themselves. All members are collective unless
/// said otherwise.
class InputFiles {
 public:
  using Kept = std::map<std::string, InputFile>;

  /// `kept`, of which rank 0's counts, is found before what lies on disk.
  explicit InputFiles(const Communicator& communicator, Kept kept = {});

  /// The text, on all ranks; none when the file cannot be read. Of a file larger than `limit` bytes
  /// one byte more than those.
  std::optional<std::string> read(const std::string& name, std::size_t limit = no_limit);

  /// Keeps a file that is read in another way, unless one is kept under this name. `path` may be
  /// empty.
  void keep(const std::string& name, const std::string& file, const std::string& path);

  /// What was read so far, on rank 0; nothing on others. Not collective.
  const Kept& kept() const { return kept_; }
  /// Paths of those whose file on disk is there and is another by now.
  static std::vector<std::string> edited(const Communicator& communicator, const Kept& kept);

  static constexpr std::size_t no_limit = static_cast<std::size_t>(-1) / 2;

 private:
  Communicator communicator_;
  Kept kept_;
};

/// The bytes of a file on this rank; none when it cannot be read. Not more than `limit` and one.
std::optional<std::string> read_bytes(const std::string& file,
                                      std::size_t limit = InputFiles::no_limit);

}  // namespace hawser
