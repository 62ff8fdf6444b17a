#include "hawser/algebra/row_layout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/assembly/assembler.hpp"
#include "hawser/assembly/constraints.hpp"
#include "hawser/assembly/field_table.hpp"
#include "mesh/tests/mesh_text.hpp"

namespace hawser {
namespace {

using testing::Each;
using testing::ElementsAre;

FieldUse temperature(Role role) {
  return FieldUse{"temperature", "K", "W", 1, RateRule::dynamic}.as(role, need::value);
}

PhysicsModule module(const std::string& name, const char* region, CellShape shape,
                     std::vector<FieldUse> uses) {
  return module_with(name, std::make_unique<LoadKernel>(region, shape, std::move(uses)));
}

/// A fluid with a line in it, a mesh that moves, and a plug-in that reads the flow.
struct Problem {
  Mesh mesh = read();
  std::vector<PhysicsModule> modules = make();
  DofMap dofs{mesh, gather_fields(modules).fields};
  Assembler assembler{dofs, modules};
  const RowLayout& layout = assembler.system().layout;

  static Mesh read() {
    MeshText text = grid(2, 2);
    text.groups.push_back(line("cable", {3, 4, 5}));
    return read_text(Communicator(), text.in_format("4.1"));
  }
  static std::vector<PhysicsModule> make() {
    std::vector<PhysicsModule> result;
    result.push_back(module("heat", "water", CellShape::triangle,
                            {velocity(Role::reads), temperature(Role::adds)}));
    result.push_back(module("mesh", "water", CellShape::triangle, {displacement(Role::governs)}));
    result.push_back(module("flow", "water", CellShape::triangle, {velocity(Role::adds)}));
    result.push_back(module("cable", "cable", CellShape::line,
                            {velocity(Role::adds), displacement(Role::kinematic)}));
    return result;
  }
  bool on_the_cable(LocalIndex row) const {
    double x[2];
    dofs.position(row, x);
    return x[1] == 1;
  }
};

TEST(RowLayout, GroupsFollowFromWhatModulesDeclare) {
  const Problem problem;
  std::vector<std::string> names;
  std::vector<bool> displaces;
  for (const RowGroup& group : problem.layout.groups) {
    names.push_back(group.name);
    displaces.push_back(group.displaces);
  }
  EXPECT_THAT(names, ElementsAre("flow, cable", "mesh", "heat"));
  EXPECT_THAT(displaces, ElementsAre(false, true, false));
  for (LocalIndex row = 0; row < problem.dofs.owned(); ++row) {
    const auto field =
        problem.dofs.fields()[static_cast<std::size_t>(problem.dofs.info(row).field)].name;
    const int expected = field == "velocity"         ? 0
                         : field == "temperature"    ? 2
                         : problem.on_the_cable(row) ? RowLayout::follows
                                                     : 1;
    EXPECT_EQ(problem.layout.group[static_cast<std::size_t>(row)], expected) << field;
  }
}

TEST(RowLayout, KnowsNodesAndWhoFollowsWhom) {
  const Problem problem;
  const RowLayout& layout = problem.layout;
  for (LocalIndex row = 0; row < problem.dofs.owned(); ++row) {
    const auto r = static_cast<std::size_t>(row);
    EXPECT_EQ(layout.node[r], problem.dofs.info(row).point);
    EXPECT_LT(layout.kind[r], layout.kinds);
  }
  EXPECT_EQ(layout.kinds, 5);
  for (const Follower& follower : layout.followers) {
    const RowInfo &from = problem.dofs.info(follower.row), &to = problem.dofs.info(follower.leader);
    EXPECT_EQ(from.point, to.point);
    EXPECT_EQ(from.component, to.component);
    EXPECT_NE(from.field, to.field);
  }
}

TEST(RowLayout, SaysWhatConditionsReplaced) {
  Problem problem;
  Constraints constraints(problem.assembler);
  if (problem.dofs.owned() > 0) constraints.prescribe({{0, 5}, {0, 7}});
  Kinematics kinematics;
  kinematics.factor = 3;
  constraints.apply(kinematics);
  EXPECT_EQ(problem.layout.factor, 3);
  EXPECT_TRUE(problem.layout.ordered);
  for (std::size_t row = 0; row < problem.layout.prescribed.size(); ++row)
    EXPECT_EQ(problem.layout.prescribed[row], row == 0 ? 1 : 0);
  constraints.prescribe({});
  constraints.apply(kinematics);
  EXPECT_THAT(problem.layout.prescribed, Each(0));
  kinematics.at_rest = true;
  constraints.apply(kinematics);
  EXPECT_FALSE(Communicator().min(problem.layout.ordered ? 1 : 0) > 0)
      << "at rest a structure's velocity is known, and its displacement is looked for";
}

}  // namespace
}  // namespace hawser
