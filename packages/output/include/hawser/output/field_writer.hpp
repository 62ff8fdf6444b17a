#pragma once
// Fields on a moving grid, as HDF5 files that ParaView opens through an index.
//
// Per output: <name>-000010.h5 (collective, the same content on any number of ranks) and
// <name>-000010.xdmf, which meshio reads, too; over all of them: <name>.vtkhdf, for ParaView from
// 5.12 on and pyvista, and <name>.xdmf, for older ones. In the HDF5 file: attributes `step` and
// `time` (s), datasets `points` [point][3] (m), `cells` [cell][vertex], `fields/<field>` with an
// attribute `unit`. Every file is complete or absent: it is written under another name, synced, and
// renamed.
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/output/grid.hpp"

namespace hawser {

class Rows;

struct SavedOutput {
  double time;       ///< s
  std::string file;  ///< HDF5, without its folder
  std::string grid;  ///< the <Grid> element of XDMF
};

class FieldWriter {
 public:
  /// Removes files of this name left in `folder` by an earlier run, but for steps up to
  /// `keep_until` (a restart), which stay in the index. Collective; OutputError on all ranks.
  FieldWriter(const Communicator& communicator, std::string folder, Grid grid, int keep_until = -1);
  ~FieldWriter();

  /// `coordinates`: present positions, [owned point][dimension], m. `time` in s. Collective;
  /// OutputError on all ranks.
  void write(int step, double time, const std::vector<double>& coordinates,
             const std::vector<PointField>& fields);

 private:
  std::string path(int step, const std::string& extension) const;
  void tidy_folder(int keep_until);

  Communicator communicator_;
  std::string folder_;
  Grid grid_;
  std::unique_ptr<Rows> points_;
  std::unique_ptr<Rows> cells_;
  std::vector<GlobalIndex> joined_;     ///< grid_.cells as positions in `points`
  std::map<int, SavedOutput> outputs_;  ///< on rank 0, by step
};

}  // namespace hawser
