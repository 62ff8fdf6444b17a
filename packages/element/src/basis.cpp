#include "hawser/element/basis.hpp"

namespace hawser {

NodeLayout node_layout(CellShape shape, Basis basis) {
  const ShapeTraits& cell = traits(shape);
  NodeLayout layout{1, 0, 0, 0, cell.vertices};
  if (basis == Basis::p1 || cell.edges == 0) return layout;
  layout.per_edge = 1;
  if (!cell.simplex) {
    layout.per_face = cell.faces > 0 ? 1 : 0;
    layout.inside = 1;
  }
  layout.count += cell.edges + layout.per_face * cell.faces + layout.inside;
  return layout;
}

}  // namespace hawser
