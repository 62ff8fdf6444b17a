#pragma once
// Where on a mesh something lives, by the names of the mesh's regions.
#include <string>
#include <utility>
#include <vector>

namespace hawser {

/// The cells of named regions, or what is made of them. A cell that lies in several of the regions
/// counts once. Names convert: "water" is the domain of its cells.
struct Domain {
  enum class Kind {
    cells,
    facets,   ///< cells of the body behind boundary regions, turned so that they begin there
    patches,  ///< pairs of neighbouring segments of line regions
    ends      ///< segments of line regions at a point region, turned so that they begin there
  };
  std::vector<std::string> regions;
  Kind kind = Kind::cells;
  std::string point{};  ///< of `ends`

  Domain() = default;
  Domain(const char* region) : regions{region} {}
  Domain(std::string region) : regions{std::move(region)} {}
  Domain(std::vector<std::string> all) : regions(std::move(all)) {}

  static Domain facets(Domain boundary);
  static Domain patches(Domain lines);
  static Domain ends(Domain lines, std::string point_region);

  /// The cells of a single region: nothing has to be made.
  bool is_region() const { return kind == Kind::cells && regions.size() == 1; }
  std::string text() const;  ///< "water", "facets of outflow", "near far", "cable at tail"

  friend bool operator==(const Domain& a, const Domain& b) {
    return a.kind == b.kind && a.regions == b.regions && a.point == b.point;
  }
};

}  // namespace hawser
