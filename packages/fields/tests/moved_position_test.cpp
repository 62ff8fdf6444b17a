#include "hawser/fields/moved_position.hpp"

#include <gtest/gtest.h>

#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

/// Values of a field by a function of the reference position, at every row.
template <class Function>
void set(const DofMap& dofs, const char* field, std::vector<double>& values, Function&& value) {
  for (LocalIndex row = 0; row < dofs.rows(); ++row) {
    if (dofs.info(row).field != dofs.find(field)) continue;
    double X[2];
    dofs.position(row, X);
    values[static_cast<std::size_t>(row)] = value(X, dofs.info(row).component);
  }
}

class MovedNodes : public testing::TestWithParam<std::tuple<Basis, Basis>> {};
INSTANTIATE_TEST_SUITE_P(Bases, MovedNodes,
                         testing::Combine(testing::Values(Basis::p1, Basis::p2),
                                          testing::Values(Basis::p1, Basis::p2)));

// A displacement that both bases can hold carries every node of every field, of either basis and on
// both sides of a slit, exactly.
TEST_P(MovedNodes, AreWhereTheDisplacementIs) {
  const auto [basis, moving] = GetParam();
  MeshText text = grid(4, 4);
  text.groups.push_back(line("cable", {11, 12, 13}));
  const Mesh mesh = read_text(Communicator(), text.in_format("4.1"), {"cable"});
  const DofMap dofs(mesh,
                    {{"temperature", "K", "W/m", 1, basis, Numbering::continuous, {"water"}},
                     {"pressure", "Pa", "m^2/s", 1, Basis::p1, Numbering::sides, {"water"}},
                     {"displacement", "m", "m", 2, moving, Numbering::continuous, {"water"}}});
  State state;
  state.value.assign(static_cast<std::size_t>(dofs.rows()), 0);
  const auto d = [](const double* X, int c) {
    return c == 0 ? 0.1 * X[0] - 0.3 * X[1] : 0.2 * X[0];
  };
  set(dofs, "displacement", state.value, d);
  const MovedPosition moved(dofs, "displacement");
  for (LocalIndex row = 0; row < dofs.rows(); ++row) {
    double X[2], x[2];
    dofs.position(row, X);
    moved.position(row, state, x);
    for (int j = 0; j < 2; ++j)
      EXPECT_NEAR(x[j], X[j] + d(X, j), 1e-15)
          << dofs.fields()[static_cast<std::size_t>(dofs.info(row).field)].name;
  }
}

TEST(MovedPosition, NothingMovesWithoutADisplacement) {
  const Mesh mesh = read_text(Communicator(), grid(1, 1).in_format("4.1"));
  const DofMap dofs(mesh,
                    {{"temperature", "K", "W/m", 1, Basis::p2, Numbering::continuous, {"water"}}});
  State state;
  state.value.assign(static_cast<std::size_t>(dofs.rows()), 7);
  const MovedPosition moved(dofs, "displacement");
  for (LocalIndex row = 0; row < dofs.rows(); ++row) {
    double X[2], x[2];
    dofs.position(row, X);
    moved.position(row, state, x);
    EXPECT_EQ(moved.displacement_at(row).count, 0);
    EXPECT_EQ(X[0], x[0]);
  }
}

}  // namespace
}  // namespace hawser
