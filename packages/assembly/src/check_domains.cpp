#include "hawser/assembly/check_domains.hpp"

#include "hawser/fields/look_up.hpp"

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

}  // namespace

std::vector<Domain> domains_of(const std::vector<PhysicsModule>& modules) {
  std::vector<Domain> domains;
  for (const PhysicsModule& module : modules)
    for (const auto& kernel : module.kernels)
      domains.push_back(kernel->domain());
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
}

}  // namespace hawser
