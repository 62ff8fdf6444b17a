#pragma once
// Where the displacement has carried a node of any field: by the displacement's own shape functions
// there. The one place for x = X + d at nodes.
#include "hawser/fields/dof_map.hpp"
#include "hawser/fields/state.hpp"

namespace hawser {

/// The displacement at a node: sum over `count` of weight * value of the rows first[k], first[k] +
/// 1, ...
struct NodeDisplacement {
  int count = 0;  ///< 0 where nothing moves
  LocalIndex first[2] = {-1, -1};
  double weight = 1;

  double component(const std::vector<double>& values, int j) const {
    double sum = 0;
    for (int k = 0; k < count; ++k)
      sum += weight * values[static_cast<std::size_t>(first[k] + j)];
    return sum;
  }
};

class MovedPosition {
 public:
  /// `displacement`: name of the field that moves the mesh; it may be absent. The map must outlive
  /// this.
  MovedPosition(const DofMap& dofs, const std::string& displacement);

  NodeDisplacement displacement_at(PointKind kind, LocalIndex point) const;
  NodeDisplacement displacement_at(LocalIndex row) const {
    return displacement_at(dofs_.info(row).kind, dofs_.info(row).point);
  }

  /// x = X + d of a row's node, `dofs.mesh().dimension` numbers, m.
  void position(LocalIndex row, const State& state, double* x) const;

 private:
  const DofMap& dofs_;
  int field_;
};

}  // namespace hawser
