#pragma once
// What a field is made of on a cell, and how its nodes are counted where cells meet. Both are the
// run's to choose, not a kernel's: see FieldUse for what a module may wish.
#include "hawser/element/cell_shape.hpp"

namespace hawser {

enum class Basis {
  p1,  ///< continuous, of degree 1 (per direction on quadrilaterals and hexahedra: Q1)
  p2   ///< continuous, of degree 2 (Q2)
};

/// Nodes of a basis per vertex, edge, face and interior of a cell, and in all. Wherever nodes of a
/// cell are listed: vertices, then edges, faces and interior, each in the order of the traits.
struct NodeLayout {
  int per_vertex, per_edge, per_face, inside;
  int count;
};

NodeLayout node_layout(CellShape shape, Basis basis);

constexpr int polynomial_degree(Basis basis) { return basis == Basis::p1 ? 1 : 2; }
constexpr const char* to_string(Basis basis) { return basis == Basis::p1 ? "P1" : "P2"; }

enum class Numbering {
  continuous,  ///< one node per vertex, edge, ... of the mesh
  sides        ///< one per side where the mesh is slit, else the same
};

constexpr const char* to_string(Numbering numbering) {
  return numbering == Numbering::continuous ? "continuous" : "sides";
}

}  // namespace hawser
