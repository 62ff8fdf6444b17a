#pragma once
// In which cell of the body, as it has moved, a place is.
#include <optional>
#include <vector>

#include "hawser/element/tabulation.hpp"
#include "hawser/fields/dof_map.hpp"
#include "hawser/fields/state.hpp"

namespace hawser {

class CellLocator {
 public:
  /// Of the body's cells that this rank counts. `moving`: the field that moves the mesh, or -1.
  CellLocator(const DofMap& dofs, int moving);

  /// From here on cells are where they are in this state.
  void move_to(const State& state);

  struct Place {
    LocalIndex cell;
    double xi[3];  ///< in the reference cell
  };
  /// The cell of the least number, where several meet; none where the place is in no cell of this
  /// rank. On the boundary is inside, to 1e-8 of a cell.
  std::optional<Place> find(const double* x) const;

  /// The box of all ranks' cells: least x, y (, z), then greatest. Collective.
  std::vector<double> box() const;

 private:
  bool invert(LocalIndex cell, const double* x, double* xi) const;
  void sort_into_bins();
  std::size_t bin(const double* x, std::vector<std::size_t>& along) const;

  const DofMap& dofs_;
  const Region& body_;
  int moving_;
  bool placed_ = false;
  std::size_t dimension_, nodes_;
  Tabulation middle_;                             // of the map, in the middle of the reference cell
  std::vector<LocalIndex> cells_;                 // counted here, ascending
  std::vector<double> nodes_of_;                  // [cell of cells_][node][dimension], m
  std::vector<double> low_, high_;                // [cell of cells_][dimension], m
  std::vector<double> origin_, width_;            // of the bins, per dimension
  std::vector<std::size_t> bins_;                 // how many, per dimension
  std::vector<std::vector<std::size_t>> in_bin_;  // places in cells_, ascending
};

}  // namespace hawser
