#include "hawser/assembly/constraints.hpp"

#include <gtest/gtest.h>

#include <map>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/field_table.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

/// A quadratic velocity on a mesh whose displacement is linear.
struct Problem {
  Mesh mesh = read_text(Communicator(), grid(1, 1).in_format("4.1"));
  std::vector<PhysicsModule> modules = make();
  DofMap dofs{mesh, gather_fields(modules).fields};
  Assembler assembler{dofs, modules};

  static std::vector<PhysicsModule> make() {
    std::vector<PhysicsModule> modules;
    modules.push_back(module_with(
        "sample",
        std::make_unique<LoadKernel>("water", CellShape::triangle,
                                     std::vector<FieldUse>{velocity(Role::adds).wishing(Basis::p2),
                                                           displacement(Role::governs)})));
    return modules;
  }
  std::map<LocalIndex, double> row(LocalIndex row) {
    std::map<LocalIndex, double> entries;
    for (int k = 0; k < assembler.row_size(row); ++k)
      if (assembler.row_values(row)[k] != 0)
        entries[assembler.row_columns(row)[k]] = assembler.row_values(row)[k];
    return entries;
  }
};

TEST(Constraints, APrescribedRowSaysValueMinusPrescription) {
  Problem problem;
  State state;
  state.value.assign(static_cast<std::size_t>(problem.dofs.rows()), 3);
  Constraints constraints(problem.assembler);
  constraints.prescribe({{0, 5}, {0, 7}});
  std::vector<double> residual(state.value.size()), magnitude(state.value.size());
  constraints.apply(state, {}, residual, magnitude);
  if (problem.dofs.owned() == 0) return;
  EXPECT_EQ(residual[0], 3 - 7) << "the later one rules";
  EXPECT_EQ(magnitude[0], 3 + 7);
}

// The middle of an edge moves with both of its ends.
TEST(Constraints, AMidEdgeFollowsTheLinearDisplacementOfBothEnds) {
  Problem problem;
  const MovedPosition moved(problem.dofs, "displacement");
  Constraints constraints(problem.assembler);
  std::vector<PrescribedRow> rows;
  for (LocalIndex row = 0; row < problem.dofs.owned(); ++row)
    if (problem.dofs.info(row).kind == PointKind::edge)
      rows.push_back({row, 0, moved.displacement_at(row), {2, 6, 0}});
  constraints.prescribe(rows);
  constraints.apply(Kinematics{});
  for (const PrescribedRow& row : rows) {
    ASSERT_EQ(row.displacement.count, 2);
    std::map<LocalIndex, double> expected{{row.row, 1}};
    for (const LocalIndex end : row.displacement.first) {
      expected[end] = -1;
      expected[end + 1] = -3;
    }
    EXPECT_EQ(problem.row(row.row), expected);
  }
}

}  // namespace
}  // namespace hawser
