#pragma once
// A strip of triangles and a line along it, dealt out to the ranks in a scattered way.
#include <cmath>
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/output/grid.hpp"

namespace hawser::sample {

constexpr int columns = 7;  // points 0..6 at the bottom, 7..13 on top; 6 squares of two triangles

inline bool is_mine(const Communicator& all, GlobalIndex id) {
  return (id * 5 + 2) % all.size() == all.rank();
}
inline double x(GlobalIndex id) { return 10.0 * static_cast<double>(id % columns); }
inline double y(GlobalIndex id) { return id < columns ? 0.0 : 1.0 + 0.1 * static_cast<double>(id); }

inline Grid strip(const Communicator& all) {
  Grid grid;
  grid.name = "flow";
  grid.point_count = 2 * columns;
  grid.cell_count = 2 * (columns - 1);
  for (GlobalIndex id = grid.point_count - 1; id >= 0; --id) {  // descending: order must not matter
    if (is_mine(all, id)) grid.point_ids.push_back(id);
  }
  for (GlobalIndex id = 0; id < grid.cell_count; ++id) {
    if (!is_mine(all, id)) continue;
    const GlobalIndex a = id / 2;
    grid.cell_ids.push_back(id);
    const bool lower = id % 2 == 0;
    grid.cells.insert(grid.cells.end(),
                      {a, lower ? a + 1 : a + columns + 1, lower ? a + columns + 1 : a + columns});
  }
  return grid;
}

/// Every second point of the bottom, so numbered with gaps: ids 100, 102, 104, 106.
inline Grid cable(const Communicator& all) {
  Grid grid;
  grid.name = "cable";
  grid.kind = CellKind::line;
  grid.point_count = 4;
  grid.cell_count = 3;
  for (GlobalIndex i = 0; i < 4; ++i) {
    if (is_mine(all, i)) grid.point_ids.push_back(100 + 2 * i);
    if (i == 3 || !is_mine(all, i)) continue;
    grid.cell_ids.push_back(i);
    grid.cells.insert(grid.cells.end(), {100 + 2 * i, 102 + 2 * i});
  }
  return grid;
}

inline std::vector<double> coordinates(const Grid& grid, double time) {
  std::vector<double> values;
  for (const GlobalIndex id : grid.point_ids) {
    values.push_back(x(id) + time);
    values.push_back(y(id));
  }
  return values;
}

inline std::vector<PointField> fields(const Grid& grid, double time) {
  PointField pressure{"pressure", "Pa", 1, {}};
  PointField velocity{"velocity", "m/s", 2, {}};
  for (const GlobalIndex id : grid.point_ids) {
    const double s = static_cast<double>(id);
    pressure.values.push_back(std::sqrt(s) + time);
    velocity.values.push_back(1.0 / (1.0 + s));
    velocity.values.push_back(-time * s);
  }
  PointField tension{"tension", "N", 1, {}, true};
  for (const GlobalIndex id : grid.cell_ids)
    tension.values.push_back(10.0 * static_cast<double>(id) + time);
  return {pressure, velocity, tension};
}

}  // namespace hawser::sample
