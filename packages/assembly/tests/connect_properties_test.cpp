// Who supplies what to whom, and what is said when it does not work out.
#include "hawser/assembly/connect_properties.hpp"

#include <gtest/gtest.h>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/check_domains.hpp"
#include "hawser/base/error.hpp"
#include "hawser/physics/formula_property.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

constexpr PropertyUse stiffness{"stiffness", "Pa"};

/// Uses the stiffness.
class UsingKernel : public LoadKernel {
 public:
  explicit UsingKernel(PropertyConstant constant, const PropertyUse& use = stiffness)
      : LoadKernel("water", CellShape::triangle, {velocity(Role::adds)}) {
    own_properties() = KernelProperties({use}, {std::move(constant)});
  }
};

struct Given {
  std::string region, formula, name = "stiffness";
  bool adds = true;
};

/// On two by two squares; `part` has some of their triangles.
Mesh squares(const std::vector<PhysicsModule>& modules) {
  MeshText text = grid(2, 2);
  return read_text(Communicator(), text.in_format("4.1"), {}, domains_of(modules));
}

std::vector<PhysicsModule> modules_with(PropertyConstant constant, const std::vector<Given>& given,
                                        const PropertyUse& use = stiffness) {
  std::vector<PhysicsModule> modules;
  modules.push_back(module_with("user", std::make_unique<UsingKernel>(std::move(constant), use)));
  for (const Given& one : given) {
    PhysicsModule module{"giver", "", {}, {}};
    module.supplies.push_back(
        {one.region, one.adds,
         std::make_unique<FormulaProperty>(
             PropertyUse{one.name.c_str(), "Pa"}, 2,
             FieldExpressions{FieldExpression(one.formula, {"deck.xml", 7, 3})})});
    modules.push_back(std::move(module));
  }
  return modules;
}

std::string said(PropertyConstant constant, const std::vector<Given>& given) {
  std::vector<PhysicsModule> modules = modules_with(std::move(constant), given);
  const Mesh mesh = squares(modules);
  Diagnostics diagnostics;
  resolve_properties(modules, diagnostics);
  if (diagnostics.ok()) connect_properties(mesh, modules, diagnostics);
  return diagnostics.ok() ? "" : diagnostics.error_text();
}

const std::vector<double> one = {1};

TEST(ConnectProperties, SuppliesAddToEachOtherAndToAConstant) {
  EXPECT_EQ(said(std::nullopt, {{"water", "2"}, {"water", "3"}}), "");
  EXPECT_EQ(said(one, {{"water", "velocity_x"}}), "");
  EXPECT_EQ(said(std::nullopt, {{"water", "2", "stiffness", false}}), "");
}

TEST(ConnectProperties, WhatNobodyGivesIsTold) {
  EXPECT_EQ(
      said(std::nullopt, {}),
      "(default): module 'user' needs 'stiffness' (Pa) on all of 'water', and nobody gives it "
      "there: neither an attribute of the module, nor <property>, nor another module");
}

TEST(ConnectProperties, WhatNobodyUsesIsToldWithTheNearestName) {
  EXPECT_EQ(said(one, {{"water", "2", "stifness"}}),
            "(default): module 'giver' supplies 'stifness', which no module of this run uses; used "
            "are stiffness; did you mean 'stiffness'?");
}

TEST(ConnectProperties, OneThatDoesNotAddMustBeAlone) {
  EXPECT_NE(said(one, {{"water", "2", "stiffness", false}})
                .find("gets 'stiffness' from its own attribute and from"),
            std::string::npos);
  EXPECT_NE(said(std::nullopt, {{"water", "2"}, {"water", "2", "stiffness", false}})
                .find("on the same cells, and not both of them add"),
            std::string::npos);
}

TEST(ConnectProperties, FormulasNameFieldsOfTheRun) {
  EXPECT_EQ(said(one, {{"water", "2*velocity_z"}}),
            "deck.xml:7:3: 'velocity_z' in the formula '2*velocity_z' is the third component of a "
            "field of two");
  EXPECT_EQ(said(one, {{"water", "dz(velocity_x)"}}),
            "deck.xml:7:3: 'dz(velocity_x)' in the formula 'dz(velocity_x)' is a derivative along "
            "z, and the mesh is one in the plane");
  EXPECT_EQ(said(one, {{"water", "velocty_x"}}),
            "deck.xml:7:3: 'velocty_x' in the formula 'velocty_x' is no field of this run and no "
            "parameter; there "
            "are velocity_x, velocity_y; did you mean 'velocity_x'?");
}

TEST(ConnectProperties, UnitsAgree) {
  std::vector<PhysicsModule> modules = modules_with(one, {{"water", "2"}}, {"stiffness", "N"});
  const Mesh mesh = squares(modules);
  Diagnostics diagnostics;
  EXPECT_THROW(resolve_properties(modules, diagnostics), PluginError);
}

TEST(ConnectProperties, WhatALawReadsBecomesAFieldOfItsUser) {
  std::vector<PhysicsModule> modules = modules_with(one, {{"water", "dx(velocity_y)"}});
  const Mesh mesh = squares(modules);
  Diagnostics diagnostics;
  resolve_properties(modules, diagnostics);
  connect_properties(mesh, modules, diagnostics);
  ASSERT_TRUE(diagnostics.ok()) << diagnostics.error_text();
  const Kernel& kernel = *modules[0].kernels[0];
  ASSERT_EQ(kernel.fields().size(), 2u);
  EXPECT_STREQ(kernel.fields()[1].name, "displacement");
  EXPECT_TRUE(kernel.properties().supplied());
}

}  // namespace
}  // namespace hawser
