#include "hawser/assembly/assembler.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/check_domains.hpp"
#include "hawser/assembly/field_table.hpp"
#include "hawser/base/error.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Says that it has two nodes, whatever its cells have.
class TwoNodeKernel : public LoadKernel {
 public:
  using LoadKernel::LoadKernel;
  int nodes(std::size_t /*field*/) const override { return 2; }
};

void assemble(std::unique_ptr<Kernel> kernel, const std::vector<FieldDeck>& decisions = {}) {
  MeshText text = grid(2, 2);
  text.groups.push_back(line("cable", {3, 4, 5}));
  std::vector<PhysicsModule> modules(1);
  modules[0].name = modules[0].block = "sample";
  modules[0].location = {"deck.xml", 4, 3};
  modules[0].kernels.push_back(std::move(kernel));
  const Mesh mesh = read_text(Communicator(), text.in_format("4.1"), {}, domains_of(modules));
  const DofMap dofs(mesh, gather_fields(modules, decisions).fields);
  const Assembler assembler(dofs, modules);
}

// Cells of as many vertices as the kernel has nodes are not yet its cells.
TEST(Assembler, AKernelFitsTheCellsOfItsRegion) {
  const auto uses = [] { return std::vector<FieldUse>{velocity(Role::adds)}; };
  const Domain patches = Domain::patches("cable"), facets = Domain::facets("wall");
  EXPECT_THAT([&] { assemble(std::make_unique<LoadKernel>(facets, CellShape::line, uses())); },
              ThrowsMessage<PluginError>(HasSubstr("module 'sample' on 'facets of wall' is written "
                                                   "for lines, and that region is one of "
                                                   "triangles")));
  EXPECT_THAT([&] { assemble(std::make_unique<TwoNodeKernel>(patches, CellShape::line, uses())); },
              ThrowsMessage<DeckError>(HasSubstr("is written for 2 nodes of the field 'velocity' "
                                                 "per cell, and in P1 it has 3")));
  EXPECT_NO_THROW(assemble(std::make_unique<LoadKernel>(facets, CellShape::triangle, uses())));
  EXPECT_NO_THROW(assemble(std::make_unique<LoadKernel>(patches, CellShape::line, uses())));
}

TEST(Assembler, AnElementKernelWorksWithItsOwnNodesOnly) {
  const FieldDeck quadratic{{"velocity", {}}, Basis::p2, {}};
  const auto uses = [] { return std::vector<FieldUse>{velocity(Role::adds)}; };
  EXPECT_THAT(
      [&] {
        assemble(std::make_unique<LoadKernel>("cable", CellShape::line, uses()), {quadratic});
      },
      ThrowsMessage<DeckError>(
          HasSubstr("deck.xml:4:3: module 'sample' on 'cable' is written for 2 nodes of the "
                    "field 'velocity' per cell, and in P2 it has 3")));
  EXPECT_NO_THROW(
      assemble(std::make_unique<LoadKernel>("water", CellShape::triangle, uses()), {quadratic}));
}

TEST(Assembler, ARateThatAnotherFieldGivesAsksForThatField) {
  std::vector<FieldUse> uses = {StandardFields<2>::displacement.as(Role::governs, need::rate)};
  EXPECT_THAT([&] { assemble(std::make_unique<LoadKernel>("water", CellShape::triangle, uses)); },
              ThrowsMessage<PluginError>(HasSubstr("looks at the rate of 'displacement' and must "
                                                   "list 'velocity' too")));
}

}  // namespace
}  // namespace hawser
