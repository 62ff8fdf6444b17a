// A case is what its deck says, wherever that comes from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "hawser/base/error.hpp"
#include "hawser/simulation/run_deck.hpp"
#include "sample_deck.hpp"

namespace hawser {
namespace {

using testing::HasSubstr;

std::string fault_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const DeckError& error) {
    return error.what();
  }
  return "none";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

TEST(Case, FromTextGivesEveryFaultItsPlace) {
  const Environment environment;
  const std::string wrong = replaced(replaced(sample_deck, "segments=\"10\"", "segments=\"ten\""),
                                     "<cable region", "<cable reigon");
  const std::string fault = fault_of([&] { Case::from_text(environment, wrong, "string.xml"); });
  EXPECT_THAT(fault, HasSubstr("string.xml:4:"));
  EXPECT_THAT(fault, HasSubstr("'ten'"));
  EXPECT_THAT(fault, HasSubstr("string.xml:7:12:"));
  EXPECT_THAT(fault, HasSubstr("region"));
}

TEST(Case, FromTextAndFromAFileAreTheSame) {
  const Environment environment;
  environment.communicator().on_root([] { std::ofstream("string.xml") << sample_deck; });
  EXPECT_EQ(Case::from_text(environment, sample_deck, "string.xml").resolved_deck(),
            Case::from_file(environment, "string.xml").resolved_deck());
}

TEST(Case, TextMayExtendAFile) {
  const Environment environment;
  environment.communicator().on_root([] { std::ofstream("base.xml") << sample_deck; });
  const Case run_case = Case::from_text(
      environment, R"(<hawser extends="base.xml"><time end="0.04"/></hawser>)", "longer.xml");
  EXPECT_EQ(run_case.deck().time.end, 0.04);
  EXPECT_EQ(run_case.deck().title, "String");
}

TEST(Case, ObeysItsOptions) {
  const Environment environment;
  CaseOptions options;
  options.changes = {{"amplitude", "0.02"}, {"time/step", "0.02"}};
  options.end = 0.04;
  const Case run_case = Case::from_text(environment, sample_deck, "string.xml", options);
  EXPECT_EQ(run_case.deck().time.step, 0.02);
  EXPECT_EQ(run_case.deck().time.end, 0.04);
  EXPECT_THAT(run_case.resolved_deck(), HasSubstr("value=\"0.02\""));
  options.changes = {{"amplitud", "0.02"}};
  EXPECT_THAT(fault_of([&] { Case::from_text(environment, sample_deck, "string.xml", options); }),
              HasSubstr("did you mean 'amplitude'"));
}

TEST(Case, MakesNewModulesEachTime) {
  const Environment environment;
  const Case run_case = Case::from_text(environment, sample_deck);
  for (int i = 0; i < 2; ++i) {
    const std::vector<PhysicsModule> modules = run_case.make_modules();
    ASSERT_EQ(modules.size(), 1u);
    EXPECT_FALSE(modules.front().kernels.empty());
  }
}

}  // namespace
}  // namespace hawser
