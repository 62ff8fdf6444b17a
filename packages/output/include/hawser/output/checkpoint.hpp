#pragma once
// The complete state in one file, written and read on any number of ranks.
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/base/types.hpp"

namespace hawser {

struct CheckpointNotes {
  std::map<std::string, double> numbers;     ///< time step, controller state, ...
  std::map<std::string, std::string> texts;  ///< resolved deck, version, ...

  /// Another's notes under names that begin with `prefix`, and those again without it.
  void add(const std::string& prefix, const CheckpointNotes& notes);
  CheckpointNotes part(const std::string& prefix) const;
};

struct CheckpointHeader : CheckpointNotes {
  int step = 0;
  double time = 0;  ///< s
};

/// One value per rank-independent id in [0, global_count) and component.
struct NamedArray {
  std::string name;
  int components = 1;
  GlobalIndex global_count = 0;
  std::vector<GlobalIndex> ids;  ///< of this rank's entries; over all ranks each id occurs once
  std::vector<double> values;    ///< [entry][component]
};

/// A file that the run has read, such as a table; of rank 0 alone.
struct KeptFile {
  std::string name;  ///< as the run asks for it
  std::string path;  ///< absolute; empty when it never was a file
  std::string text;
};

/// What is in one, but for the files that the run has read.
struct Checkpoint {
  CheckpointHeader header;
  std::vector<NamedArray> arrays;
};

/// All or nothing: a file already at `path` is replaced only when the new one is safely on disk and
/// was read again without a fault; it goes to `previous`, unless that is empty. Collective;
/// OutputError on all ranks.
void write_checkpoint(const Communicator& communicator, const std::string& path,
                      const Checkpoint& checkpoint, const std::vector<KeptFile>& files = {},
                      const std::string& previous = "");

/// Where the one before `path` is kept.
std::string previous_checkpoint(const std::string& path);

/// Opening checks that every byte of the file, and every value in it, is what was written.
/// All members are collective; OutputError on all ranks.
class CheckpointReader {
 public:
  CheckpointReader(const Communicator& communicator, const std::string& path);
  ~CheckpointReader();

  const std::string& path() const { return path_; }

  const CheckpointHeader& header() const { return header_; }
  bool has(const std::string& name) const;
  std::vector<std::string> names() const;  ///< of all arrays
  GlobalIndex global_count(const std::string& name) const;

  /// The values of any ids, in their order: [id][component]. Several ranks may ask for the same id.
  std::vector<double> read(const std::string& name, const std::vector<GlobalIndex>& ids,
                           int components) const;

  /// All of them, on rank 0; empty on the others.
  std::vector<KeptFile> files() const;

 private:
  class File;
  std::string path_;
  std::unique_ptr<File> file_;
  CheckpointHeader header_;
};

/// The checkpoint at `path`, or, when it is damaged or gone, the one before it.
struct OpenedCheckpoint {
  std::unique_ptr<CheckpointReader> reader;
  std::string damage;  ///< of the one that was asked for; empty when that was opened
};
/// Collective; OutputError on all ranks when neither can be trusted.
OpenedCheckpoint open_checkpoint(const Communicator& communicator, const std::string& path);

}  // namespace hawser
