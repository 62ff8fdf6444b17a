#pragma once
// Mesh, fields, equations and solver of one run, built in the order in which they depend on each
// other.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hawser/assembly/field_table.hpp"
#include "hawser/base/error.hpp"
#include "hawser/report/reports.hpp"
#include "hawser/simulation/case.hpp"
#include "hawser/solve/nonlinear_driver.hpp"
#include "hawser/time/coupled_problem.hpp"
#include "hawser/time/energy_ledger.hpp"

namespace hawser {

struct System {
  Mesh mesh;
  std::vector<PhysicsModule> modules;
  FieldTable table;
  std::unique_ptr<DofMap> dofs;
  std::unique_ptr<Assembler> assembler;
  std::unique_ptr<Conditions> conditions;
  std::unique_ptr<TimeIntegrator> integrator;
  std::unique_ptr<CoupledProblem> problem;
  std::unique_ptr<EnergyLedger> energy;  ///< none where neither the deck nor a report asks for it
  std::unique_ptr<NonlinearDriver> driver;
  std::unique_ptr<Reports> reports;
  std::vector<std::string> notes;  ///< worth a user's look
};

/// Collective. MeshError, or DeckError with every name that the mesh or
/// the modules do not know.
std::unique_ptr<System> build_system(const Case& run_case, const std::string& mesh_file);

/// "velocity y at (x, y) m" for error messages.
std::string describe_row(const DofMap& dofs, GlobalIndex global_row);

}  // namespace hawser
