#include "hawser/assembly/field_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/tests/sample_modules.hpp"
#include "hawser/base/error.hpp"

namespace hawser {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

PhysicsModule module_of(const std::string& name, std::vector<FieldUse> uses) {
  return module_with(name,
                     std::make_unique<LoadKernel>("water", CellShape::triangle, std::move(uses)));
}

template <class... Module>
std::vector<PhysicsModule> list(Module&&... module) {
  std::vector<PhysicsModule> result;
  (result.push_back(std::move(module)), ...);
  return result;
}

FieldDeck decide(const std::string& name, std::optional<Basis> basis,
                 std::optional<Numbering> numbering = {}) {
  return {{name, {"deck.xml", 3, 5}}, basis, numbering};
}

TEST(FieldTable, IsLinearAndContinuousWhereNobodyWishes) {
  const auto table = gather_fields(list(module_of("flow", {velocity(Role::adds)})));
  ASSERT_EQ(table.fields.size(), 1U);
  EXPECT_EQ(table.fields[0].basis, Basis::p1);
  EXPECT_EQ(table.fields[0].numbering, Numbering::continuous);
}

TEST(FieldTable, AWishOfOneModuleIsTheFieldsOfAll) {
  const auto modules =
      list(module_of("cable", {velocity(Role::adds)}),
           module_of("flow", {velocity(Role::adds).wishing(Basis::p2).wishing(Numbering::sides)}),
           module_of("reader", {velocity(Role::reads).wishing(Basis::p1)}));
  const auto table = gather_fields(modules);
  EXPECT_EQ(table.fields[0].basis, Basis::p2);
  EXPECT_EQ(table.fields[0].numbering, Numbering::sides);
}

TEST(FieldTable, WishesThatContradictEachOtherAreAnError) {
  const auto modules = list(module_of("flow", {velocity(Role::adds).wishing(Basis::p1)}),
                            module_of("other", {velocity(Role::adds).wishing(Basis::p2)}));
  EXPECT_THAT([&] { gather_fields(modules); },
              ThrowsMessage<DeckError>(HasSubstr(
                  "module 'other' wishes the basis P2 for the field 'velocity', and module 'flow' "
                  "P1; say which with <field name=\"velocity\" basis=\"...\"/>")));
  EXPECT_EQ(gather_fields(modules, {decide("velocity", Basis::p2)}).fields[0].basis, Basis::p2);
}

TEST(FieldTable, TheDeckDecides) {
  const auto modules = list(module_of("flow", {velocity(Role::adds).wishing(Numbering::sides)}));
  const auto table = gather_fields(modules, {decide("velocity", Basis::p2, Numbering::continuous)});
  EXPECT_EQ(table.fields[0].basis, Basis::p2);
  EXPECT_EQ(table.fields[0].numbering, Numbering::continuous);
}

TEST(FieldTable, AModuleMayBeWrittenForOneBasisAlone) {
  const auto modules = list(module_of("flow", {velocity(Role::adds).only(Basis::p1)}));
  EXPECT_THAT([&] { gather_fields(modules, {decide("velocity", Basis::p2)}); },
              ThrowsMessage<DeckError>(HasSubstr(
                  "module 'flow' is written for the field 'velocity' in P1, and it is in P2")));
}

TEST(FieldTable, ADecisionAboutNoFieldIsAnError) {
  const auto modules = list(module_of("flow", {velocity(Role::adds)}));
  EXPECT_THAT([&] { gather_fields(modules, {decide("velocty", Basis::p2)}); },
              ThrowsMessage<DeckError>(HasSubstr("deck.xml:3:5: no module solves for a field "
                                                 "'velocty'; there are velocity; did you mean "
                                                 "'velocity'?")));
}

TEST(FieldTable, TheMeshIsNotTornAtSlits) {
  const auto modules = list(module_of("mesh", {displacement(Role::governs)}));
  EXPECT_THAT([&] { gather_fields(modules, {decide("displacement", {}, Numbering::sides)}); },
              ThrowsMessage<DeckError>(HasSubstr("the displacement moves the mesh")));
}

TEST(FieldTable, AFieldThatIsReadMustBeSolved) {
  FieldUse misspelt = velocity(Role::reads);
  misspelt.name = "velocty";
  auto reader = module_of("reader", {misspelt});
  reader.location = {"deck.xml", 7, 3};
  const auto modules = list(module_of("flow", {velocity(Role::adds)}), std::move(reader));
  EXPECT_THAT([&] { gather_fields(modules); },
              ThrowsMessage<DeckError>(
                  HasSubstr("deck.xml:7:3: module 'reader' reads the field 'velocty', which no "
                            "module solves for; there are velocity; did you mean 'velocity'?")));
}

TEST(FieldTable, AFieldMayBeReadIfItIsSolved) {
  const auto modules =
      list(module_of("flow", {velocity(Role::adds), displacement(Role::reads_if_solved)}));
  EXPECT_EQ(gather_fields(modules).fields.size(), 1U);
}

TEST(FieldTable, OneFieldHasOneDescription) {
  FieldUse other = velocity(Role::adds);
  other.unit = "kn";
  for (const Role role : {Role::adds, Role::reads}) {
    other.role = role;
    const auto modules =
        list(module_of("flow", {velocity(Role::adds)}), module_of("other", {other}));
    EXPECT_THAT([&] { gather_fields(modules); },
                ThrowsMessage<PluginError>(HasSubstr(
                    "module 'other' and another one describe the field 'velocity' differently")));
  }
}

}  // namespace
}  // namespace hawser
