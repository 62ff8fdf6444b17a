#include "msh_groups.hpp"

#include <algorithm>

#include "hawser/base/error.hpp"

namespace hawser {

void name_groups(MshFile& file) {
  const auto given = file.groups;  // a group's names must not depend on those made before
  const auto taken = [&](std::size_t asks, const std::string& name) {
    for (std::size_t g = 0; g < given.size(); ++g) {
      const bool is_its =
          given[g].name == name || (given[g].name.empty() && std::to_string(given[g].tag) == name);
      if (g != asks && is_its) return true;
    }
    return false;
  };
  static const char* const kinds[] = {"point_", "curve_", "surface_", "volume_"};
  for (std::size_t g = 0; g < given.size(); ++g) {
    if (!given[g].name.empty()) continue;
    std::string& name = file.groups[g].name = std::to_string(given[g].tag);
    if (!taken(g, name)) continue;
    name = kinds[given[g].dimension] + name;
    if (taken(g, name))
      throw MeshError(file.path + ": the physical group " + std::to_string(given[g].tag) +
                      " of dimension " + std::to_string(given[g].dimension) +
                      " has no name, and '" + name + "' is another's; name it in gmsh");
  }
}

}  // namespace hawser
