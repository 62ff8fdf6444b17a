#include "hawser/element/cell_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace hawser {
namespace {

constexpr CellShape solids[] = {CellShape::tetrahedron, CellShape::hexahedron};
constexpr CellShape shapes[] = {CellShape::line, CellShape::triangle, CellShape::quadrilateral,
                                CellShape::tetrahedron, CellShape::hexahedron};

TEST(ShapeTraits, EulersRelation) {
  for (const CellShape shape : solids)
    EXPECT_EQ(traits(shape).vertices - traits(shape).edges + traits(shape).faces, 2);
  for (const CellShape shape : {CellShape::triangle, CellShape::quadrilateral})
    EXPECT_EQ(traits(shape).vertices, traits(shape).edges);
}

// In a simplex every pair of vertices is an edge; in a cube those that differ in one coordinate.
TEST(ShapeTraits, EdgesJoinNeighbours) {
  for (const CellShape shape : shapes) {
    const ShapeTraits& cell = traits(shape);
    std::set<std::pair<int, int>> listed, expected;
    for (int e = 0; e < cell.edges; ++e)
      listed.insert(std::minmax(cell.edge[e][0], cell.edge[e][1]));
    for (int a = 0; a < cell.vertices; ++a)
      for (int b = a + 1; b < cell.vertices; ++b) {
        int differing = 0;
        for (int k = 0; k < 3; ++k)
          differing += cell.vertex[a][k] != cell.vertex[b][k] ? 1 : 0;
        if (cell.simplex || differing == 1) expected.insert({a, b});
      }
    EXPECT_EQ(listed, expected) << cell.plural;
  }
}

// Seen from outside a face runs counter-clockwise: its normal points away from the other vertices.
TEST(ShapeTraits, FacesPointOutwards) {
  for (const CellShape shape : solids) {
    const ShapeTraits& cell = traits(shape);
    std::set<std::set<int>> distinct;
    for (int f = 0; f < cell.faces; ++f) {
      const auto* const x = cell.vertex[cell.face[f][0]];
      const auto* const y = cell.vertex[cell.face[f][1]];
      const auto* const z = cell.vertex[cell.face[f][2]];
      double a[3], b[3];
      for (int k = 0; k < 3; ++k) {
        a[k] = y[k] - x[k];
        b[k] = z[k] - x[k];
      }
      const double normal[] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                               a[0] * b[1] - a[1] * b[0]};
      const std::set<int> own(cell.face[f], cell.face[f] + cell.vertices_per_face);
      distinct.insert(own);
      for (int v = 0; v < cell.vertices; ++v) {
        double height = 0;
        for (int k = 0; k < 3; ++k)
          height += normal[k] * (cell.vertex[v][k] - x[k]);
        if (own.count(v) != 0)
          EXPECT_EQ(height, 0);
        else
          EXPECT_LT(height, 0);
      }
    }
    EXPECT_EQ(static_cast<int>(distinct.size()), cell.faces);
  }
}

}  // namespace
}  // namespace hawser
