#pragma once
// What modules ask of the mesh, before and after it is read.
#include <vector>

#include "hawser/deck/diagnostics.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/physics/kernel.hpp"

namespace hawser {

/// Of all kernels, for read_mesh().
std::vector<Domain> domains_of(const std::vector<PhysicsModule>& modules);

/// An error where a kernel's domain is not there, or is not of the dimension or cells that the
/// kernel is written for. The same on all ranks.
void check_domains(const Mesh& mesh, const std::vector<PhysicsModule>& modules,
                   Diagnostics& diagnostics);

}  // namespace hawser
