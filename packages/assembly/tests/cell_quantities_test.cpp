#include <gtest/gtest.h>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/assembler.hpp"
#include "hawser/assembly/field_table.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

/// Tells where its cell is.
class PlaceKernel : public LoadKernel {
 public:
  using LoadKernel::LoadKernel;
  std::vector<Quantity> quantities() const override {
    return {{"place", "m"}, {"pull", "N", true}};
  }
  void evaluate(const CellInput& cell, double* values) const override {
    values[0] = 0.5 * (cell.coordinates[0] + cell.coordinates[2]);
    values[1] = 0.5 * (cell.coordinates[1] + cell.coordinates[3]);
  }
};

TEST(CellQuantities, OfARegionComeFromAKernelOnSeveral) {
  MeshText text = grid(3, 2);
  text.groups.push_back(line("first", {4, 5, 6}));
  text.groups.push_back(line("second", {7, 6, 5}));  // shares a segment, the other way round
  std::vector<PhysicsModule> modules;
  modules.push_back(module_with(
      "flow", std::make_unique<LoadKernel>("water", CellShape::triangle,
                                           std::vector<FieldUse>{velocity(Role::adds)})));
  const Domain both(std::vector<std::string>{"first", "second"});
  modules.push_back(module_with(
      "cable", std::make_unique<PlaceKernel>(both, CellShape::line,
                                             std::vector<FieldUse>{velocity(Role::adds)})));
  const Mesh mesh = read_text(Communicator(), text.in_format("4.1"), {}, {both});
  const DofMap dofs(mesh, gather_fields(modules).fields);
  const Assembler assembler(dofs, modules);
  State state;
  for (auto* array :
       {&state.value, &state.rate, &state.accepted, &state.rate_slope, &state.rate_partner})
    array->assign(static_cast<std::size_t>(dofs.rows()), 0);
  const auto found = assembler.cell_quantities(mesh.region("second"), state);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].unit, "m");
  EXPECT_EQ(found[1].unit, "N/m");  // a body in the plane
  const auto& ids = mesh.region("second").cell_ids;
  ASSERT_EQ(found[0].values.size(), ids.size());
  for (std::size_t c = 0; c < ids.size(); ++c) {
    EXPECT_EQ(found[0].values[c], ids[c] == 0 ? 2.5 : 1.5);
    EXPECT_EQ(found[1].values[c], 1);
  }
  EXPECT_TRUE(assembler.cell_quantities(mesh.region("wall"), state).empty());
}

}  // namespace
}  // namespace hawser
