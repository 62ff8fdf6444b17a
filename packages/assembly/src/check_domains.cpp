#include "hawser/assembly/check_domains.hpp"

#include <algorithm>

#include "hawser/fields/look_up.hpp"
#include "src/cell_vertices.hpp"

namespace hawser {
namespace {

/// Whether there is what the kernel lives on, and if not, why.
void check_domain(const Mesh& mesh, const PhysicsModule& module, const Kernel& kernel,
                  Diagnostics& diagnostics) {
  const Domain& domain = kernel.domain();
  const std::string user = "module '" + module.name + "'";
  const std::size_t before = diagnostics.error_count();
  const bool cells = domain.kind == Domain::Kind::cells;
  for (const std::string& name : domain.regions)
    find_region_of(cells ? kernel.shapes() : std::vector<CellShape>{CellShape::line}, mesh,
                   {name, module.location}, user, diagnostics);
  if (domain.kind == Domain::Kind::ends)
    find_region_of({CellShape::point}, mesh, {domain.point, module.location}, user, diagnostics);
  if (diagnostics.error_count() != before) return;
  const std::string names = "region '" + Domain(domain.regions).text() + "'";
  if (mesh.find(domain) != nullptr) return;
  if (domain.kind == Domain::Kind::facets) {
    diagnostics.error(module.location, names + " is no line on the boundary of the body");
  } else if (domain.kind == Domain::Kind::patches) {
    diagnostics.error(module.location, names + " is no line of at least two segments");
  } else {
    diagnostics.error(module.location, "'" + domain.point + "' is no point of " + names);
  }
}

/// Cells on which a module works, by their sorted vertices; of this rank.
std::set<Vertices> cells_of(const Mesh& mesh, const PhysicsModule& module) {
  std::set<Vertices> cells;
  for (const auto& kernel : module.kernels) {
    const Region* const region = mesh.find(kernel->domain());
    if (region != nullptr && kernel->domain().kind == Domain::Kind::cells)
      insert_cells(*region, cells);
  }
  return cells;
}

bool governs(const PhysicsModule& module) {
  for (const auto& kernel : module.kernels)
    for (const FieldUse& use : kernel->fields())
      if (use.role == Role::governs) return true;
  return false;
}

/// Two of a kind on one cell are there twice: twice the mass, twice the stiffness. Of those that
/// govern a field the second one is refused by its rows (governance.hpp).
void refuse_twice(const Mesh& mesh, const std::vector<PhysicsModule>& modules,
                  Diagnostics& diagnostics) {
  for (std::size_t b = 0; b < modules.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      if (modules[a].name != modules[b].name || governs(modules[b])) continue;
      const auto first = cells_of(mesh, modules[a]), second = cells_of(mesh, modules[b]);
      const bool both = std::any_of(second.begin(), second.end(),
                                    [&](const auto& cell) { return first.count(cell) > 0; });
      if (mesh.communicator.any(both))
        diagnostics.error(modules[b].location,
                          "module '" + modules[b].name + "' lives on cells where the one of " +
                              modules[a].location.text() +
                              " does already: everything there would count twice; let each have "
                              "its own cells, or one of them all");
    }
}

}  // namespace

std::vector<Domain> domains_of(const std::vector<PhysicsModule>& modules) {
  std::vector<Domain> domains;
  for (const PhysicsModule& module : modules)
    for (const auto& kernel : module.kernels)
      domains.push_back(kernel->domain());
  for (const PhysicsModule& module : modules)
    for (const Supply& supply : module.supplies)
      domains.push_back(supply.on);
  return domains;
}

void check_domains(const Mesh& mesh, const std::vector<PhysicsModule>& modules,
                   Diagnostics& diagnostics) {
  for (const PhysicsModule& module : modules)
    for (const auto& kernel : module.kernels) {
      if (kernel->dimension() == mesh.dimension) {
        check_domain(mesh, module, *kernel, diagnostics);
        continue;
      }
      diagnostics.error(module.location, "module '" + module.name + "' is written for " +
                                             std::to_string(kernel->dimension()) +
                                             " dimensions, the mesh has " +
                                             std::to_string(mesh.dimension));
      break;
    }
  for (const PhysicsModule& module : modules)
    for (const Supply& supply : module.supplies)
      for (const std::string& name : supply.on.regions)
        find_region_of(body_shapes(mesh.dimension), mesh, {name, module.location},
                       "module '" + module.name + "'", diagnostics);
  if (diagnostics.ok()) refuse_twice(mesh, modules, diagnostics);
}

}  // namespace hawser
