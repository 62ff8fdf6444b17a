#include "hawser/assembly/check_domains.hpp"

#include <gtest/gtest.h>

#include "assembly/tests/sample_modules.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

/// What is said of a kernel for cells of that shape, on two by two squares with a line inside.
std::string complaint(const Domain& domain, CellShape shape) {
  std::vector<PhysicsModule> modules;
  modules.push_back(module_with(
      "load",
      std::make_unique<LoadKernel>(domain, shape, std::vector<FieldUse>{velocity(Role::adds)})));
  MeshText text = grid(2, 2);
  text.groups.push_back(line("cable", {3, 4, 5}));
  text.groups.push_back(line("stub", {4, 7}));
  text.groups.push_back({"end", 0, {{3}}});
  const Mesh mesh = read_text(Communicator(), text.in_format("4.1"), {}, domains_of(modules));
  Diagnostics diagnostics;
  check_domains(mesh, modules, diagnostics);
  return diagnostics.ok()
             ? ""
             : diagnostics.error_text().substr(diagnostics.error_text().find("):") + 3);
}

TEST(Domains, ThatAreThereAreFine) {
  const Domain lines(std::vector<std::string>{"cable", "stub"});
  EXPECT_EQ(complaint("water", CellShape::triangle), "");
  EXPECT_EQ(complaint(lines, CellShape::line), "");
  EXPECT_EQ(complaint(Domain::patches("cable"), CellShape::line), "");
  EXPECT_EQ(complaint(Domain::facets("wall"), CellShape::triangle), "");
  EXPECT_EQ(complaint(Domain::ends("cable", "end"), CellShape::line), "");
}

TEST(Domains, HaveCellsOfTheKernelsShape) {
  EXPECT_EQ(complaint("cable", CellShape::triangle),
            "module 'load' needs a region of triangles, and 'cable' is one of lines; there are "
            "water");
}

TEST(Domains, ThatCannotBeMadeAreExplained) {
  EXPECT_EQ(complaint(Domain::facets("cable"), CellShape::triangle),
            "region 'cable' is no line on the boundary of the body");
  EXPECT_EQ(complaint(Domain::patches("stub"), CellShape::line),
            "region 'stub' is no line of at least two segments");
  EXPECT_EQ(complaint(Domain::ends("stub", "end"), CellShape::line),
            "'end' is no point of region 'stub'");
  EXPECT_EQ(complaint(Domain::patches("water"), CellShape::line),
            "module 'load' needs a region of lines, and 'water' is one of triangles; there are "
            "wall, cable, stub");
}

}  // namespace
}  // namespace hawser
