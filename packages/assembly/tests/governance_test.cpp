#include "hawser/assembly/governance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/assembler.hpp"
#include "hawser/assembly/field_table.hpp"
#include "hawser/base/error.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

/// Two by two squares with a line through the middle: vertices 3, 4, 5.
Mesh sample_mesh() {
  MeshText text = grid(2, 2);
  text.groups.push_back(line("cable", {3, 4, 5}));
  return read_text(Communicator(), text.in_format("4.1"));
}

constexpr double flow_load = 1, cable_load = 10, mesh_load = 100;

PhysicsModule flow() {
  return module_with(
      "flow", std::make_unique<LoadKernel>("water", CellShape::triangle,
                                           std::vector<FieldUse>{velocity(Role::adds)}, flow_load));
}
PhysicsModule cable() {
  return module_with(
      "cable",
      std::make_unique<LoadKernel>(
          "cable", CellShape::line,
          std::vector<FieldUse>{velocity(Role::adds), displacement(Role::kinematic)}, cable_load));
}
PhysicsModule mesh_motion(const std::string& name = "mesh") {
  return module_with(name, std::make_unique<LoadKernel>(
                               "water", CellShape::triangle,
                               std::vector<FieldUse>{displacement(Role::governs)}, mesh_load));
}

template <class... Module>
std::vector<PhysicsModule> list(Module&&... module) {
  std::vector<PhysicsModule> result;
  (result.push_back(std::move(module)), ...);
  return result;
}

bool on_the_cable(const DofMap& dofs, LocalIndex row) {
  double x[2];
  dofs.position(row, x);
  return x[1] == 1;
}

TEST(Governance, AStructureTakesItsNodesFromTheMesh) {
  const Mesh mesh = sample_mesh();
  const auto modules = list(flow(), mesh_motion(), cable());
  const DofMap dofs(mesh, gather_fields(modules).fields);
  const Governance governance = find_governors(dofs, modules);
  const int moving = dofs.find("displacement");
  for (LocalIndex row = 0; row < dofs.owned(); ++row) {
    const int governor = governance.governor[static_cast<std::size_t>(row)];
    if (dofs.info(row).field != moving)
      EXPECT_EQ(governor, Governance::shared);
    else
      EXPECT_EQ(governor, on_the_cable(dofs, row) ? Governance::kinematic : 1);
  }
}

TEST(Governance, TwoGovernorsOfEqualRankAreAnErrorOfTheDeck) {
  const Mesh mesh = sample_mesh();
  const auto modules = list(mesh_motion("springs"), mesh_motion("elastic"));
  const DofMap dofs(mesh, gather_fields(modules).fields);
  EXPECT_THAT(
      [&] { find_governors(dofs, modules); },
      testing::ThrowsMessage<DeckError>("(default): <elastic> governs the field 'displacement' at "
                                        "nodes where <springs> of (default) "
                                        "does already; let one of them cover both regions"));
}

/// Cells of a region that touch the vertex of a row: 6 at the most.
double touching(const DofMap& dofs, LocalIndex row, const char* region_name) {
  const Region& region = dofs.mesh().region(region_name);
  return static_cast<double>(
      std::count(region.vertices.begin(), region.vertices.end(), dofs.info(row).point));
}

TEST(Assembler, AddsModulesUpAndTellsThemApart) {
  const Mesh mesh = sample_mesh();
  const auto modules = list(flow(), mesh_motion(), cable());
  const DofMap dofs(mesh, gather_fields(modules).fields);
  const Assembler assembler(dofs, modules);
  State state;
  for (auto* array :
       {&state.value, &state.rate, &state.accepted, &state.rate_slope, &state.rate_partner})
    array->assign(static_cast<std::size_t>(dofs.rows()), 0);
  std::vector<double> total, magnitude, of_flow, of_mesh, of_cable;
  assembler.residual(state, of_flow, 0);
  assembler.residual(state, of_mesh, 1);
  assembler.residual(state, of_cable, 2);
  assembler.residual(state, total, magnitude);

  const int moving = dofs.find("displacement");
  for (LocalIndex row = 0; row < dofs.owned(); ++row) {
    const auto r = static_cast<std::size_t>(row);
    const double triangles = touching(dofs, row, "water"), lines = touching(dofs, row, "cable");
    const bool is_velocity = dofs.info(row).field != moving;
    EXPECT_EQ(of_flow[r], is_velocity ? triangles * flow_load : 0);
    EXPECT_EQ(of_cable[r], is_velocity ? lines * cable_load : 0);
    // What the mesh would add to the structure's rows can be asked for, but never counts.
    EXPECT_EQ(of_mesh[r], is_velocity ? 0 : triangles * mesh_load);
    EXPECT_EQ(total[r], of_flow[r] + of_cable[r] + (on_the_cable(dofs, row) ? 0 : of_mesh[r]));
    EXPECT_EQ(magnitude[r], total[r]);
  }
}

}  // namespace
}  // namespace hawser
