#pragma once
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

/// Cuts the whole mesh into the parts of the ranks; the rules are in mesh.hpp.
class MeshCutter {
 public:
  MeshCutter(const Mesh& whole, const std::vector<int>& owner_of_vertex, int parts);
  Mesh part(int rank) const;

 private:
  void cut_regions(Mesh& part, int rank) const;
  std::vector<LocalIndex> order_vertices(Mesh& part, int rank) const;

  const Mesh& whole_;
  const std::vector<int>& owner_of_vertex_;
  std::vector<std::vector<std::vector<LocalIndex>>> cells_;  // [rank][region]: cells to be held
};

}  // namespace hawser
