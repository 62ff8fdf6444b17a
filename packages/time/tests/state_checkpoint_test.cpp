// What is saved comes back, also of fields that live on a part of the mesh.
#include "hawser/time/state_checkpoint.hpp"

#include <gtest/gtest.h>

#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

TEST(StateCheckpoint, HoldsFieldsOnAPartOfTheMesh) {
  MeshText text = grid(4, 2);
  text.groups.push_back(line("cable", {5, 6, 7, 8, 9}));
  const Mesh mesh = read_text(Communicator(), text.in_format("4.1"), {"cable"});
  const DofMap dofs(mesh,
                    {{"velocity", "m/s", "N/m", 2, Basis::p1, Numbering::continuous, {"water"}},
                     {"heat", "K", "W", 1, Basis::p2, Numbering::continuous, {"cable"}},
                     {"pressure", "Pa", "m^2/s", 1, Basis::p1, Numbering::sides, {"water"}}});
  TimeHistory saved;
  saved.time = 3, saved.step = 0.5, saved.earlier_step = 0.25;
  for (LocalIndex row = 0; row < dofs.rows(); ++row) {
    const auto value = static_cast<double>(dofs.global_rows()[static_cast<std::size_t>(row)]) + 1;
    saved.value.push_back(value);
    saved.rate.push_back(-value);
    saved.quotient.push_back(10 * value);
    saved.earlier_rate.push_back(100 * value);
  }
  CheckpointHeader header;
  header.step = 6;
  save_history(dofs, saved, header, "part.h5");
  const TimeHistory loaded = load_history(dofs, CheckpointReader(mesh.communicator, "part.h5"));
  EXPECT_EQ(loaded.time, 3);
  EXPECT_EQ(loaded.step, 0.5);
  EXPECT_EQ(loaded.earlier_step, 0.25);
  EXPECT_EQ(loaded.value, saved.value);
  EXPECT_EQ(loaded.rate, saved.rate);
  EXPECT_EQ(loaded.quotient, saved.quotient);
  EXPECT_EQ(loaded.earlier_rate, saved.earlier_rate);
}

}  // namespace
}  // namespace hawser
