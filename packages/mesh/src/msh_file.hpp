#pragma once
// The content of a gmsh file as written there: its own node numbers, any order.
#include <array>
#include <string>
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

struct MshNode {
  long long tag;
  int line;  ///< of the file, for messages; 0 in a binary one
  std::array<double, 3> position;
};

struct MshGroup {
  std::string name;
  int dimension;
  long long tag;
};

/// An element of two groups stands here twice; elements of no group are left out.
struct MshElement {
  long long tag;
  int line;
  CellShape shape;
  int group;
  std::array<long long, 8> nodes;  ///< as many as the shape has vertices
};

struct MshFile {
  std::string path;
  std::vector<MshNode> nodes;
  std::vector<MshGroup> groups;
  std::vector<MshElement> elements;
  std::array<long long, 4> left_out{};  ///< by dimension: elements of no group
};

/// MSH 2.2 and 4.1, ASCII or binary, whole or partitioned (the parts are forgotten). A group
/// without a name is called by its number, where that is another group's name or number too
/// "point_7", "curve_7" or "surface_7". MeshError with file and line, or byte.
MshFile read_msh(const std::string& path);

}  // namespace hawser
