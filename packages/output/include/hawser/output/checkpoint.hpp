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

/// All or nothing: a file already at `path` is replaced only when the new one is safely on disk.
/// Collective; OutputError on all ranks.
void write_checkpoint(const Communicator& communicator, const std::string& path,
                      const CheckpointHeader& header, const std::vector<NamedArray>& arrays);

/// Opening checks that the file is a complete checkpoint whose values are what was written.
/// All members are collective; OutputError on all ranks.
class CheckpointReader {
 public:
  CheckpointReader(const Communicator& communicator, const std::string& path);
  ~CheckpointReader();

  const CheckpointHeader& header() const { return header_; }
  bool has(const std::string& name) const;
  std::vector<std::string> names() const;  ///< of all arrays
  GlobalIndex global_count(const std::string& name) const;

  /// The values of any ids, in their order: [id][component]. Several ranks may ask for the same id.
  std::vector<double> read(const std::string& name, const std::vector<GlobalIndex>& ids,
                           int components) const;

 private:
  class File;
  std::unique_ptr<File> file_;
  CheckpointHeader header_;
};

}  // namespace hawser
