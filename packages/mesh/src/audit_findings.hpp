#pragma once
// What an audit found, and the words for where.
#include <string>
#include <vector>

#include "hawser/mesh/mesh_audit.hpp"

namespace hawser {

/// "'water', 'wall'".
std::string in_quotes(const std::vector<std::string>& names);

class Findings {
 public:
  explicit Findings(const Mesh& mesh) : mesh_(mesh) {}

  void error(const std::string& sentence) {
    all_.push_back({MeshFinding::Weight::error, sentence});
  }
  void note(const std::string& sentence) { all_.push_back({MeshFinding::Weight::note, sentence}); }
  const std::vector<MeshFinding>& all() const { return all_; }

  /// "at (0, 0), (1, 0), (2, 0) and 4 more".
  std::string places(const std::vector<LocalIndex>& vertices) const;
  /// Of first corners of cells of the body.
  std::string places_of_cells(const std::vector<LocalIndex>& cells) const;
  /// "from (0, 0) to (4, 0), 4 m".
  std::string pieces(const std::vector<LocalIndex>& edges) const;
  /// In quotes, the regions of any dimension that have one of these vertices.
  std::string regions_at(const std::vector<LocalIndex>& vertices) const;

 private:
  const Mesh& mesh_;
  std::vector<MeshFinding> all_;
};

}  // namespace hawser
