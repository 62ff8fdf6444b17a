#pragma once
// Shapes of cells and what there is to know about each. Whoever needs a number of vertices or the
// ends of an edge asks here; a new shape is one entry of the table.

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

const ShapeTraits& traits(CellShape shape);

}  // namespace hawser
