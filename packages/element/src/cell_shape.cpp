#include "hawser/element/cell_shape.hpp"

#include <cstddef>

namespace hawser {
namespace {

// In the order of CellShape.
constexpr ShapeTraits table[] = {
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

}  // namespace

const ShapeTraits& traits(CellShape shape) { return table[static_cast<std::size_t>(shape)]; }

}  // namespace hawser
