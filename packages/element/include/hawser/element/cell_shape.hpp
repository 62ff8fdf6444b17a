#pragma once
// Shapes of cells and what there is to know about each. Whoever needs a number of vertices or the
// ends of an edge asks here; a new shape is one entry of the table.
#include <cstddef>
#include <vector>

namespace hawser {

enum class CellShape {
  point,
  line,
  triangle,       ///< counter-clockwise
  quadrilateral,  ///< counter-clockwise
  tetrahedron,    ///< the fourth vertex on the side from which the others run counter-clockwise
  hexahedron      ///< a quadrilateral, then the one opposite to it
};

/// The reference cell: the unit simplex for line, triangle and tetrahedron, the unit square and
/// cube [0, 1]^n for quadrilateral and hexahedron. Numbering as in VTK, gmsh and Shards.
struct ShapeTraits {
  const char* plural;  ///< "triangles"
  int dimension;
  int vertices;
  int edges;
  int faces;  ///< of a solid; 0 below three dimensions
  int vertices_per_face;
  bool simplex;         ///< with straight edges it is an affine image of the reference cell
  double measure;       ///< length, area or volume of the reference cell
  double vertex[8][3];  ///< reference coordinates
  int edge[12][2];      ///< the vertices that each edge joins
  int face[6][4];       ///< the vertices of each face, seen from outside counter-clockwise
};

/// In the order of CellShape.
inline constexpr ShapeTraits shape_table[] = {
    {"points", 0, 1, 0, 0, 0, true, 1, {}, {}, {}},
    {"lines", 1, 2, 1, 0, 0, true, 1, {{0}, {1}}, {{0, 1}}, {}},
    {"triangles",
     2,
     3,
     3,
     0,
     0,
     true,
     1.0 / 2,
     {{0, 0}, {1, 0}, {0, 1}},
     {{0, 1}, {1, 2}, {2, 0}},
     {}},
    {"quadrilaterals",
     2,
     4,
     4,
     0,
     0,
     false,
     1,
     {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
     {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
     {}},
    {"tetrahedra",
     3,
     4,
     6,
     4,
     3,
     true,
     1.0 / 6,
     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
     {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}},
     {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 2, 1}}},
    {"hexahedra",
     3,
     8,
     12,
     6,
     4,
     false,
     1,
     {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
     {{0, 1},
      {1, 2},
      {2, 3},
      {3, 0},
      {4, 5},
      {5, 6},
      {6, 7},
      {7, 4},
      {0, 4},
      {1, 5},
      {2, 6},
      {3, 7}},
     {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}}}};

constexpr const ShapeTraits& traits(CellShape shape) {
  return shape_table[static_cast<std::size_t>(shape)];
}

/// Those that fill a plane or space.
inline std::vector<CellShape> body_shapes(int dimension) {
  if (dimension == 2) return {CellShape::triangle, CellShape::quadrilateral};
  return {CellShape::tetrahedron, CellShape::hexahedron};
}

}  // namespace hawser
