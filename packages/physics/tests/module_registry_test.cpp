#include "hawser/physics/module_registry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

struct Springs {
  double stiffness = 1;
  static Spec<Springs> spec() {
    return Spec<Springs>("springs", "Springs.")
        .attribute("stiffness", &Springs::stiffness, "N/m", positive(), "Of each.");
  }
};

PhysicsModule make(const std::string& name) {
  PhysicsModule module;
  module.name = name;
  return module;
}

TEST(ModuleRegistry, MakesAModuleFromItsParameters) {
  ModuleRegistry registry;
  registry.add<Springs>(
      [](const Springs& springs) { return make(std::to_string(springs.stiffness)); });
  EXPECT_EQ(registry.tags(), std::vector<std::string>{"springs"});
  EXPECT_EQ(registry.find("dampers"), nullptr);
  Diagnostics diagnostics;
  const Deck deck = parse_deck("<springs stiffness=\"2\"/>", "text", diagnostics);
  EXPECT_EQ(registry.find("springs")->make(deck.root, {}, diagnostics).name, std::to_string(2.0));
  EXPECT_TRUE(diagnostics.ok());
}

TEST(ModuleRegistry, FaultyParametersMakeNone) {
  ModuleRegistry registry;
  registry.add<Springs>([](const Springs&) { return make("springs"); });
  Diagnostics diagnostics;
  const Deck deck = parse_deck("<springs stiffness=\"-2\"/>", "text", diagnostics);
  EXPECT_EQ(registry.find("springs")->make(deck.root, {}, diagnostics).name, "");
  EXPECT_EQ(diagnostics.error_count(), 1U);
}

TEST(ModuleRegistry, ATagIsTakenOnce) {
  ModuleRegistry registry;
  const auto add = [&] { registry.add<Springs>([](const Springs&) { return make("springs"); }); };
  add();
  EXPECT_THAT(add, testing::ThrowsMessage<PluginError>(testing::HasSubstr("<springs>")));
}

}  // namespace
}  // namespace hawser
