#include "msh_types.hpp"

#include <map>

namespace hawser {

std::optional<CellShape> shape_of(long long type) {
  switch (type) {
    case 15: return CellShape::point;
    case 1: return CellShape::line;
    case 2: return CellShape::triangle;
    default: return std::nullopt;
  }
}

int nodes_of(long long type) {
  static const std::map<long long, int> nodes = {
      {1, 2},   {2, 3},   {3, 4},   {4, 4},   {5, 8},   {6, 6},   {7, 5},   {8, 3},   {9, 6},
      {10, 9},  {11, 10}, {12, 27}, {13, 18}, {14, 14}, {15, 1},  {16, 8},  {17, 20}, {18, 15},
      {19, 13}, {20, 9},  {21, 10}, {22, 12}, {23, 15}, {24, 15}, {25, 21}, {26, 4},  {27, 5},
      {28, 6},  {29, 20}, {30, 35}, {31, 56}, {36, 16}, {37, 25}, {92, 64}, {93, 125}};
  const auto found = nodes.find(type);
  return found == nodes.end() ? 0 : found->second;
}

std::string what_is_refused(long long type) {
  const std::string read = "; only points, lines and triangles of first order are read: ";
  switch (type) {
    case 3:
    case 10:
    case 16: return "a quadrilateral" + read + "mesh without Recombine (Mesh.RecombineAll = 0)";
    case 4: return "a tetrahedron" + read + "mesh the plane only (gmsh -2)";
    case 8:
    case 26: return "a line of higher order" + read + "write it with Mesh.ElementOrder = 1";
    case 9:
    case 21: return "a triangle of higher order" + read + "write it with Mesh.ElementOrder = 1";
    default: return "of gmsh's type " + std::to_string(type) + read + "mesh with gmsh -2 -order 1";
  }
}

}  // namespace hawser
