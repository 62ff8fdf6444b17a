#include "hawser/assembly/check_domains.hpp"

#include <gtest/gtest.h>

#include "assembly/tests/sample_modules.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

/// What is said of a kernel for cells of so many nodes, on two by two squares with a line inside.
std::string complaint(const Domain& domain, int nodes) {
  std::vector<PhysicsModule> modules;
  modules.push_back(module_with(
      "load",
      std::make_unique<LoadKernel>(domain, nodes, std::vector<FieldUse>{velocity(Role::adds)})));
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
  EXPECT_EQ(complaint("water", 3), "");
  EXPECT_EQ(complaint(lines, 2), "");
  EXPECT_EQ(complaint(Domain::patches("cable"), 3), "");
  EXPECT_EQ(complaint(Domain::facets("wall"), 3), "");
  EXPECT_EQ(complaint(Domain::ends("cable", "end"), 2), "");
}

TEST(Domains, HaveCellsOfTheKernelsNodes) {
  EXPECT_EQ(complaint("cable", 3),
            "module 'load' needs a region of triangles, and 'cable' is one of lines; there are "
            "water");
  EXPECT_EQ(complaint(Domain::facets("wall"), 2),
            "module 'load' is written for cells of 2 vertices, the facets of wall have 3");
  EXPECT_EQ(complaint(Domain::patches("cable"), 2),
            "module 'load' is written for cells of 2 vertices, the patches of cable have 3");
}

TEST(Domains, ThatCannotBeMadeAreExplained) {
  EXPECT_EQ(complaint(Domain::facets("cable"), 3),
            "region 'cable' is no line on the boundary of the body");
  EXPECT_EQ(complaint(Domain::patches("stub"), 3),
            "region 'stub' is no line of at least two segments");
  EXPECT_EQ(complaint(Domain::ends("stub", "end"), 2), "'end' is no point of region 'stub'");
  EXPECT_EQ(complaint(Domain::patches("water"), 3),
            "module 'load' needs a region of lines, and 'water' is one of triangles; there are "
            "wall, cable, stub");
}

}  // namespace
}  // namespace hawser
