#pragma once
// The flow on the moved mesh with what the kernels tell of its cells, and every line on which a
// module works as a grid of its own.
#include <memory>
#include <string>
#include <vector>

#include "hawser/output/field_writer.hpp"
#include "hawser/report/report.hpp"

namespace hawser {

class FieldOutput {
 public:
  /// `keep_until`: steps of an earlier run that stay (a restart), else -1. `reports` must outlive
  /// it; they may put lines in order and add fields to their grids.
  FieldOutput(const Assembler& assembler, const std::vector<PhysicsModule>& modules,
              const std::vector<std::unique_ptr<Report>>& reports, const std::string& folder,
              int keep_until);

  bool writes() const { return flow_ || !lines_.empty(); }  ///< there is anything to write
  /// Collective; OutputError on all ranks.
  void write(int step, const State& state);

 private:
  struct LineGrid {
    const Region* region;
    const LineGeometry* order;       // null: as the mesh numbers it
    std::vector<LocalIndex> points;  // owned vertices, ascending
    std::vector<int> fields;         // that live there, but for the displacement
    std::unique_ptr<FieldWriter> writer;
  };
  void add_line(const Region& region, const std::string& folder, int keep_until);
  void write_flow(int step, const State& state);
  void write_line(const LineGrid& line, int step, const State& state);
  std::vector<PointField> body_quantities(const State& state) const;
  PointField at_points(const LineGrid& line, int field, const State& state) const;

  const Assembler& assembler_;
  const DofMap& dofs_;
  const std::vector<std::unique_ptr<Report>>& reports_;
  std::unique_ptr<FieldWriter> flow_;  // null where there is no body
  std::vector<LineGrid> lines_;
};

}  // namespace hawser
