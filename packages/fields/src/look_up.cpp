#include "hawser/fields/look_up.hpp"

#include <algorithm>
#include <vector>

namespace hawser {
namespace {

template <class Predicate>
std::vector<std::string> names_of(const Mesh& mesh, Predicate&& wanted) {
  std::vector<std::string> names;
  for (const Region& region : mesh.regions)
    if (wanted(region)) names.push_back(region.name);
  return names;
}

}  // namespace

const Region* find_region(const Mesh& mesh, const std::string& name, const Location& where,
                          Diagnostics& diagnostics) {
  const Region* const region = mesh.find(name);
  if (region == nullptr) {
    const auto names = names_of(mesh, [](const Region&) { return true; });
    diagnostics.error(where, "the mesh has no region '" + name + "'; it has " + listed(names) +
                                 did_you_mean(name, names));
  }
  return region;
}

const Region* find_region_of(const std::vector<CellShape>& shapes, const Mesh& mesh,
                             const Located<std::string>& name, const std::string& user,
                             Diagnostics& diagnostics) {
  const auto fits = [&](const Region& candidate) {
    return std::find(shapes.begin(), shapes.end(), candidate.shape) != shapes.end();
  };
  const Region* const region = find_region(mesh, name, diagnostics);
  if (region == nullptr || fits(*region)) return region;
  diagnostics.error(name.location, user + " needs a region of " + traits(shapes.front()).plural +
                                       ", and '" + name.value + "' is one of " +
                                       traits(region->shape).plural + "; there are " +
                                       listed(names_of(mesh, fits)));
  return nullptr;
}

const Region* find_point(const Mesh& mesh, const Located<std::string>& name,
                         const std::string& user, Diagnostics& diagnostics) {
  const Region* const region = find_region_of({CellShape::point}, mesh, name, user, diagnostics);
  if (region == nullptr) return nullptr;
  long long points = 0;
  for (const int owner : region->cell_owners)
    points += owner == mesh.communicator.rank() ? 1 : 0;
  points = mesh.communicator.sum(points);
  if (points == 1) return region;
  diagnostics.error(name.location, user + " needs one point, and region '" + name.value + "' has " +
                                       std::to_string(points));
  return nullptr;
}

int find_field(const DofMap& dofs, const Located<std::string>& name, Diagnostics& diagnostics) {
  const int field = dofs.find(name.value);
  if (field >= 0) return field;
  std::vector<std::string> names;
  for (const FieldDescription& there : dofs.fields())
    names.push_back(there.name);
  diagnostics.error(name.location, "no module solves for a field '" + name.value + "'; there are " +
                                       listed(names) + did_you_mean(name.value, names));
  return field;
}

}  // namespace hawser
