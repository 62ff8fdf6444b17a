#pragma once
// A small mesh with moving water and a cable, and a time integrator on it.
#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/field_table.hpp"
#include "hawser/time/time_integrator.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {

/// Water whose mesh moves, and a cable through its middle.
inline std::vector<PhysicsModule> sample_modules() {
  std::vector<PhysicsModule> modules;
  modules.push_back(module_with(
      "flow", std::make_unique<LoadKernel>(
                  "water", CellShape::triangle,
                  std::vector<FieldUse>{velocity(Role::adds), displacement(Role::governs)})));
  modules.push_back(module_with(
      "cable", std::make_unique<LoadKernel>(
                   "cable", CellShape::line,
                   std::vector<FieldUse>{velocity(Role::adds), displacement(Role::kinematic)})));
  return modules;
}

inline Mesh sample_mesh() {
  MeshText text = grid(2, 2);
  text.groups.push_back(line("cable", {3, 4, 5}));
  return read_text(Communicator(), text.in_format("4.1"));
}

struct SampleIntegrator {
  Mesh mesh = sample_mesh();
  std::vector<PhysicsModule> modules = sample_modules();
  FieldTable table = gather_fields(modules);
  DofMap dofs{mesh, table.fields};
  Assembler assembler{dofs, modules};
  TimeIntegrator integrator;
  State state;

  explicit SampleIntegrator(const TimeScheme& scheme)
      : integrator(assembler, table.rate_rules, scheme) {}
};

/// With initial rates that are to be trusted.
inline TimeScheme newmark(double beta, double gamma) {
  TimeScheme scheme;
  scheme.beta = beta, scheme.gamma = gamma;
  scheme.euler_start = false;
  return scheme;
}

}  // namespace hawser
