#include "hawser/fields/cell_locator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

class Locator : public testing::TestWithParam<Basis> {};
INSTANTIATE_TEST_SUITE_P(Bases, Locator, testing::Values(Basis::p1, Basis::p2));

/// d = (0.1 X Y, 0.2 sin X) at the nodes: with P2 the edges are bent. A point of a cell is found in
/// it again, on one rank at least, and what is outside in none.
TEST_P(Locator, FindsThePointsOfAllCells) {
  const Mesh mesh = read_text(Communicator(), grid(4, 3).in_format("4.1"));
  const DofMap dofs(mesh,
                    {{"displacement", "m", "m", 2, GetParam(), Numbering::continuous, {"water"}}});
  State state;
  state.value.assign(static_cast<std::size_t>(dofs.rows()), 0);
  for (LocalIndex row = 0; row < dofs.rows(); ++row) {
    double X[2];
    dofs.position(row, X);
    state.value[static_cast<std::size_t>(row)] =
        dofs.info(row).component == 0 ? 0.1 * X[0] * X[1] : 0.2 * std::sin(X[0]);
  }
  CellLocator locator(dofs, 0);
  locator.move_to(state);
  const double inside[] = {0.2, 0.3};
  const Quadrature point{CellShape::triangle, 1, {1}, {inside, inside + 2}};
  const Tabulation shapes = tabulate(GetParam(), point);
  for (LocalIndex cell = 0; cell < mesh.body.size(); ++cell) {
    if (mesh.body.cell_owners[static_cast<std::size_t>(cell)] != mesh.communicator.rank()) continue;
    std::vector<LocalIndex> rows;
    dofs.append_cell_rows(0, mesh.body, cell, rows);
    double x[2] = {};
    for (std::size_t a = 0; a < rows.size(); ++a) {
      double X[2];
      dofs.position(rows[a], X);
      for (std::size_t j = 0; j < 2; ++j)
        x[j] += shapes.values[a] * (X[j] + state.value[static_cast<std::size_t>(rows[a]) + j]);
    }
    const auto found = locator.find(x);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->cell, cell);
    EXPECT_NEAR(found->xi[0], 0.2, 1e-11);
    EXPECT_NEAR(found->xi[1], 0.3, 1e-11);
  }
  const double outside[] = {-0.01, 1}, above[] = {2, 3.3}, far[] = {1e6, -1e6};
  for (const double* const x : {outside, above, far})
    EXPECT_FALSE(locator.find(x).has_value());
}

TEST(CellLocator, OnVerticesAndTheBoundaryIsInside) {
  const Mesh mesh = read_text(Communicator(), grid(2, 2).in_format("4.1"));
  const DofMap dofs(mesh, {{"dye", "1", "1", 1, Basis::p1, Numbering::continuous, {"water"}}});
  CellLocator locator(dofs, -1);
  locator.move_to({});
  const double places[][2] = {{0, 0}, {2, 2}, {1, 1}, {2, 0.3}, {0.5, 0.5}};
  for (const auto& x : places)
    EXPECT_TRUE(mesh.communicator.any(locator.find(x).has_value())) << x[0] << ' ' << x[1];
  EXPECT_EQ(locator.box(), (std::vector<double>{0, 0, 2, 2}));
}

}  // namespace
}  // namespace hawser
