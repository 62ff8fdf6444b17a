#pragma once
// Quantities over time, as a CSV file that grows with the run.
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"

namespace hawser {

struct Column {
  std::string name;
  std::string unit;  ///< as in "m", "N/m"; empty when it has none
};

/// snake_case with the unit last: {"tow_force", "N/m"} is tow_force_n_per_m.
std::string quantity_name(const Column& column);

class History {
 public:
  /// The first column is the time. With `keep_until` (a restart) the rows up to that time stay.
  /// Collective, as is append(); rank 0 alone writes. OutputError on all ranks.
  History(const Communicator& communicator, std::string path, std::vector<Column> columns,
          std::optional<double> keep_until = {});

  /// One value per column, for one row or several; what rank 0 gives is written, 12 digits, and
  /// flushed.
  void append(const std::vector<double>& rows);

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  Communicator communicator_;
  std::string path_;
  std::size_t column_count_;
  std::unique_ptr<std::FILE, CloseFile> file_;  ///< on rank 0
};

}  // namespace hawser
