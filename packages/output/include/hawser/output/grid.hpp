#pragma once
// What is drawn: points, the cells that join them, and fields at either.
#include <string>
#include <vector>

#include "hawser/base/types.hpp"

namespace hawser {

enum class CellKind { line, triangle };

/// This rank's share of the points and cells of one grid. Every point and every cell is owned by
/// exactly one rank; a cell may join points of other ranks. Ids are rank-independent and need not
/// be contiguous (a cable's points keep their numbers in the mesh): files order points and cells by
/// them.
struct Grid {
  std::string name;  ///< also the start of the file names: flow, cable
  CellKind kind = CellKind::triangle;
  int dimension = 2;                   ///< of the coordinates
  GlobalIndex point_count = 0;         ///< over all ranks
  std::vector<GlobalIndex> point_ids;  ///< of the owned points
  GlobalIndex cell_count = 0;          ///< over all ranks
  std::vector<GlobalIndex> cell_ids;   ///< of the owned cells
  std::vector<GlobalIndex> cells;      ///< [owned cell][vertex]: point ids
};

/// At the points, or in the cells.
struct PointField {
  std::string name;
  std::string unit;  ///< empty when it has none
  int components = 1;
  std::vector<double> values;  ///< [owned point][component], in the order of Grid::point_ids
  /// The values are [owned cell][component], in the order of Grid::cell_ids.
  bool of_cells = false;
};

}  // namespace hawser
