// What is saved comes back, also of fields that live on a part of the mesh.
#include "hawser/time/state_checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/assembler.hpp"
#include "hawser/assembly/field_table.hpp"
#include "hawser/base/error.hpp"
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
  write_checkpoint(mesh.communicator, "part.h5", checkpoint_of(dofs, saved, {}, header));
  const TimeHistory loaded = load_history(dofs, CheckpointReader(mesh.communicator, "part.h5"));
  EXPECT_EQ(loaded.time, 3);
  EXPECT_EQ(loaded.step, 0.5);
  EXPECT_EQ(loaded.earlier_step, 0.25);
  EXPECT_EQ(loaded.value, saved.value);
  EXPECT_EQ(loaded.rate, saved.rate);
  EXPECT_EQ(loaded.quotient, saved.quotient);
  EXPECT_EQ(loaded.earlier_rate, saved.earlier_rate);
}

/// Water of which only the upper half remembers, and a line that does.
struct RememberingMesh {
  Mesh mesh = make_mesh();
  std::vector<PhysicsModule> modules = make_modules();
  FieldTable table = gather_fields(modules);
  DofMap dofs{mesh, table.fields};
  Assembler assembler{dofs, modules};

  static Mesh make_mesh() {
    MeshText text = grid(4, 4);
    MeshText::Group upper{"upper", 2, {}};
    const auto& water = text.groups[0].cells;
    upper.cells.assign(water.begin() + 16, water.end());
    text.groups.push_back(upper);
    text.groups.push_back(line("cable", {10, 11, 12, 13, 14}));
    return read_text(Communicator(), text.in_format("4.1"));
  }
  static std::vector<PhysicsModule> make_modules() {
    const std::vector<FieldUse> uses = {velocity(Role::adds)};
    std::vector<PhysicsModule> result;
    result.push_back(
        module_with("flow", std::make_unique<LoadKernel>("water", CellShape::triangle, uses)));
    result.push_back(module_with(
        "creep", std::make_unique<RememberingKernel>("upper", CellShape::triangle, uses)));
    result.push_back(
        module_with("wear", std::make_unique<RememberingKernel>("cable", CellShape::line, uses)));
    return result;
  }
};

TEST(StateCheckpoint, HoldsWhatCellsRememberByTheirNumbers) {
  RememberingMesh saved, loaded;
  ASSERT_EQ(saved.assembler.memories().size(), 2);
  for (CellMemory* const memory : saved.assembler.memories())
    for (std::size_t i = 0; i < memory->next.size(); ++i)
      memory->next[i] = 2.0 * static_cast<double>(memory->region->cell_ids[i / 2]) + double(i % 2);
  TimeHistory history;
  for (auto* array : {&history.value, &history.rate, &history.quotient, &history.earlier_rate})
    array->assign(static_cast<std::size_t>(saved.dofs.rows()), 0);
  write_checkpoint(saved.mesh.communicator, "memory.h5",
                   checkpoint_of(saved.dofs, history, saved.assembler.memories(), {}));
  const CheckpointReader reader(saved.mesh.communicator, "memory.h5");
  EXPECT_EQ(reader.global_count("memory-creep-1"), 32);  // of the body; the others hold zeros
  EXPECT_EQ(reader.global_count("memory-wear-2"), 4);
  load_memories(loaded.mesh, reader, loaded.assembler.memories());
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(loaded.assembler.memories()[k]->next, saved.assembler.memories()[k]->next);
    for (const double value : loaded.assembler.memories()[k]->accepted)
      EXPECT_EQ(value, 0) << "read from the next step on";
  }
}

TEST(StateCheckpoint, OfKernelsThatRememberedNothingIsRefused) {
  RememberingMesh sample;
  TimeHistory history;
  for (auto* array : {&history.value, &history.rate, &history.quotient, &history.earlier_rate})
    array->assign(static_cast<std::size_t>(sample.dofs.rows()), 0);
  write_checkpoint(sample.mesh.communicator, "forgetful.h5",
                   checkpoint_of(sample.dofs, history, {}, {}));
  const CheckpointReader reader(sample.mesh.communicator, "forgetful.h5");
  EXPECT_THAT([&] { load_memories(sample.mesh, reader, sample.assembler.memories()); },
              testing::ThrowsMessage<OutputError>(
                  testing::HasSubstr("'memory-creep-1' is missing or of another size")));
}

}  // namespace
}  // namespace hawser
