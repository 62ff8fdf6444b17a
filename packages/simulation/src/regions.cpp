#include "src/regions.hpp"

#include <vector>

namespace hawser {

const Region* find_region(const Mesh& mesh, const std::string& name, const Location& where,
                          Diagnostics& diagnostics) {
  const Region* const region = mesh.find(name);
  if (region == nullptr) {
    std::vector<std::string> names;
    for (const Region& there : mesh.regions)
      if (there.name.find('/') == std::string::npos) names.push_back(there.name);
    diagnostics.error(where, "the mesh has no region '" + name + "'; it has " + listed(names) +
                                 did_you_mean(name, names));
  }
  return region;
}

}  // namespace hawser
