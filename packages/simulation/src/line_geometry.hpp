#pragma once
// A line region as one ordered sequence of nodes on every rank: cables are short next to the flow.
#include <vector>

#include "hawser/fields/dof_map.hpp"
#include "hawser/fields/state.hpp"

namespace hawser {

class LineGeometry {
 public:
  /// Nodes in order from the end nearest to the vertex of `start` (a point region; its first cell).
  /// MeshError on all ranks when the region branches or falls into pieces. Collective.
  LineGeometry(const DofMap& dofs, const Region& line, const Region& start);

  const Region& region() const { return line_; }
  std::size_t size() const { return ids_.size(); }
  const std::vector<double>& arc_length() const { return arc_length_; }  ///< m, reference
  /// Local owned vertices of the line and their places in the sequence.
  struct OwnedNode {
    LocalIndex vertex;
    std::size_t place;
  };
  const std::vector<OwnedNode>& owned() const { return owned_; }

  /// [node][dimension], on every rank, of a field's values at the nodes (0 where it does not live).
  std::vector<double> gather(const std::string& field, const State& state) const;
  /// Values of the region's local cells, as one per segment in order, on every rank. Collective.
  std::vector<double> gather_cells(const std::vector<double>& values) const;
  /// Moved positions [node][dimension], m, on every rank. Collective.
  std::vector<double> positions(const State& state) const;

 private:
  const DofMap& dofs_;
  const Region& line_;
  std::vector<GlobalIndex> ids_;
  std::vector<double> reference_;
  std::vector<double> arc_length_;
  std::vector<OwnedNode> owned_;
  std::vector<std::size_t> segment_of_cell_;  // per local cell of the region
};

}  // namespace hawser
