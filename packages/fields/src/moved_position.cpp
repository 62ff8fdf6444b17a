#include "hawser/fields/moved_position.hpp"

namespace hawser {

MovedPosition::MovedPosition(const DofMap& dofs, const std::string& displacement)
    : dofs_(dofs), field_(dofs.find(displacement)) {}

NodeDisplacement MovedPosition::displacement_at(PointKind kind, LocalIndex point) const {
  NodeDisplacement result;
  if (field_ < 0) return result;
  const Mesh& mesh = dofs_.mesh();
  const auto p = static_cast<std::size_t>(point);
  const auto add = [&](PointKind where, LocalIndex node) {
    const LocalIndex row = dofs_.first_row(field_, where, node);
    if (row >= 0) result.first[result.count++] = row;
  };
  if (kind == PointKind::split_vertex)
    add(PointKind::vertex, mesh.vertex_of_split[p]);
  else
    add(kind, point);
  if (kind != PointKind::edge || result.count > 0) return result;
  // The middle of an edge where the displacement is linear.
  result.weight = 0.5;
  for (const std::size_t end : {2 * p, 2 * p + 1})
    add(PointKind::vertex, mesh.edge_ends[end]);
  return result;
}

void MovedPosition::position(LocalIndex row, const State& state, double* x) const {
  dofs_.position(row, x);
  const NodeDisplacement d = displacement_at(row);
  for (int j = 0; d.count > 0 && j < dofs_.mesh().dimension; ++j)
    x[j] += d.component(state.value, j);
}

}  // namespace hawser
