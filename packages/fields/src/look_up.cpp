#include "hawser/fields/look_up.hpp"

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

std::string kind(int vertices_per_cell) {
  if (vertices_per_cell == 1) return "points";
  return vertices_per_cell == 2 ? "lines" : "triangles";
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

const Region* find_region_of(int vertices_per_cell, const Mesh& mesh,
                             const Located<std::string>& name, const std::string& user,
                             Diagnostics& diagnostics) {
  const Region* const region = find_region(mesh, name, diagnostics);
  if (region == nullptr || region->vertices_per_cell == vertices_per_cell) return region;
  const auto fitting = names_of(mesh, [&](const Region& candidate) {
    return candidate.vertices_per_cell == vertices_per_cell;
  });
  diagnostics.error(name.location, user + " needs a region of " + kind(vertices_per_cell) +
                                       ", and '" + name.value + "' is one of " +
                                       kind(region->vertices_per_cell) + "; there are " +
                                       listed(fitting));
  return nullptr;
}

const Region* find_point(const Mesh& mesh, const Located<std::string>& name,
                         const std::string& user, Diagnostics& diagnostics) {
  const Region* const region = find_region_of(1, mesh, name, user, diagnostics);
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
