#pragma once
// What a result folder holds, for a person who comes upon it.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/output/checkpoint.hpp"

namespace hawser {

struct GridContents {
  std::string name;  ///< flow, cable
  int outputs = 0;   ///< how many times it was written
  int first_step = 0, last_step = 0;
  double first_time = 0, last_time = 0;                     ///< s
  std::vector<std::pair<std::string, std::string>> fields;  ///< name, unit
};

struct TableContents {
  std::string file;
  std::vector<std::string> columns;
  long long rows = 0;
  double last_time = 0;  ///< s
};

struct ResultContents {
  std::optional<std::string> summary;  ///< JSON text of a finished run
  std::optional<CheckpointHeader> checkpoint;
  std::vector<GridContents> grids;
  std::vector<TableContents> tables;
};

/// `path` is a result folder or a checkpoint. Collective; OutputError on all ranks when it is
/// neither or cannot be read.
ResultContents read_contents(const Communicator& communicator, const std::string& path);

}  // namespace hawser
