// Laws that switch are held on a branch until their cell leaves it, on all ranks together.
#include <gtest/gtest.h>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/assembler.hpp"
#include "hawser/assembly/field_table.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

/// Loads its nodes with 1 while a branch is held, else with 2; that of cells whose velocity is
/// positive is the wrong one. Its energy is the number of cells.
class SwitchKernel : public LoadKernel {
 public:
  using LoadKernel::LoadKernel;
  CellStatus residual(const CellInput& cell, double* residual) const override {
    std::fill(residual, residual + 6, cell.held ? 1 : 2);
    return CellStatus::ok;
  }
  bool switches() const override { return true; }
  bool on_held_branch(const CellInput& cell) const override { return cell.fields[0].value[0] <= 0; }
  std::vector<EnergyTerm> energy_terms() const override {
    return {{"cells", EnergyTerm::Kind::stored}};
  }
  void energies(const CellInput& /*cell*/, double* energies) const override { energies[0] = 1; }
};

struct Sample {
  Mesh mesh = read_text(Communicator(), grid(3, 2).in_format("4.1"));
  std::vector<PhysicsModule> modules = switching_water();
  DofMap dofs{mesh, gather_fields(modules).fields};
  Assembler assembler{dofs, modules};
  State state;

  Sample() {
    for (auto* array :
         {&state.value, &state.rate, &state.accepted, &state.rate_slope, &state.rate_partner})
      array->assign(static_cast<std::size_t>(dofs.rows()), 0);
  }
  static std::vector<PhysicsModule> switching_water() {
    std::vector<PhysicsModule> result;
    for (int i = 0; i < 2; ++i)
      result.push_back(module_with(
          "flow", std::make_unique<SwitchKernel>("water", CellShape::triangle,
                                                 std::vector<FieldUse>{velocity(Role::adds)})));
    return result;
  }
  /// Of both kernels on 12 triangles with 6 unknowns.
  double load() const {
    std::vector<double> total, magnitude;
    assembler.residual(state, total, magnitude);
    double sum = 0;
    for (const double value : total)
      sum += value;
    return mesh.communicator.sum(sum);
  }
};

TEST(Switches, AreHeldUntilTheirCellLeavesTheBranch) {
  Sample sample;
  EXPECT_EQ(sample.load(), 2 * 12 * 6 * 2);
  sample.assembler.hold_switches();
  EXPECT_EQ(sample.load(), 2 * 12 * 6);
  EXPECT_FALSE(sample.assembler.release_wrong_switches(sample.state));
  EXPECT_EQ(sample.load(), 2 * 12 * 6);
  for (LocalIndex row = 0; row < sample.dofs.rows(); ++row)
    sample.state.value[static_cast<std::size_t>(row)] = 1;
  EXPECT_TRUE(sample.assembler.release_wrong_switches(sample.state));
  EXPECT_EQ(sample.load(), 2 * 12 * 6 * 2);
  EXPECT_FALSE(sample.assembler.release_wrong_switches(sample.state));  // one way
  EXPECT_FALSE(sample.assembler.release_switches());
  sample.assembler.hold_switches();
  EXPECT_TRUE(sample.assembler.release_switches());
  EXPECT_EQ(sample.load(), 2 * 12 * 6 * 2);
}

TEST(Switches, OneRankThatLeavesItsBranchIsTold) {
  Sample sample;
  sample.assembler.hold_switches();
  double x[3];
  for (LocalIndex row = 0; row < sample.dofs.rows(); ++row) {
    sample.dofs.position(row, x);
    if (x[0] < 0.5) sample.state.value[static_cast<std::size_t>(row)] = 1;
  }
  EXPECT_TRUE(sample.assembler.release_wrong_switches(sample.state));
}

TEST(EnergySums, TermsOfOneNameAreOneAndCellsCountOnce) {
  const Sample sample;
  ASSERT_EQ(sample.assembler.energy_terms().size(), 1U);
  EXPECT_EQ(sample.assembler.energies(sample.state), std::vector<double>{24});
}

}  // namespace
}  // namespace hawser
