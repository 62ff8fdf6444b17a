// What an environment starts, and what it leaves to others. MPI is started by the test's main().
#include "hawser/simulation/environment.hpp"

#include <gtest/gtest.h>

#include "hawser/base/error.hpp"
#include "hawser/simulation/run_deck.hpp"
#include "sample_deck.hpp"

namespace hawser {
namespace {

TEST(Environment, OfOneProcessReadsDecks) {
  const Environment alone(MPI_COMM_NULL);
  EXPECT_EQ(Case::from_text(alone, sample_deck).deck().title, "String");
}

TEST(Environment, MakesAnExitCodeOfAnError) {
  const Environment alone(MPI_COMM_NULL);
  testing::internal::CaptureStderr();
  EXPECT_EQ(alone.guarded([]() -> int { throw MeshError("no such mesh"); }), 4);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "no such mesh\n");
  EXPECT_EQ(alone.guarded([] { return 7; }), 7);
}

TEST(Environment, StepsWhereMpiRunsAndLeavesItRunning) {
  {
    const Environment environment(MPI_COMM_WORLD);
    Stepper stepper(Case::from_text(environment, sample_deck));
    EXPECT_TRUE(stepper.advance().accepted);
  }
  int ended = 1;
  MPI_Finalized(&ended);
  EXPECT_EQ(ended, 0);
  EXPECT_TRUE(Communicator().any(true));
}

TEST(Environment, KnowsWhatIsBuiltIn) {
  const Environment alone(MPI_COMM_NULL);
  for (const char* tag : {"ale-fluid", "cable", "mesh-motion"})
    EXPECT_NE(alone.registries.modules.find(tag), nullptr) << tag;
  EXPECT_EQ(alone.registries.reports.specs("output").size(), 1u);  // <probe>
}

TEST(Environment, RefusesAPluginThatIsNotThere) {
  Environment alone(MPI_COMM_NULL);
  alone.plugin_folder = "nowhere";
  EXPECT_THROW(alone.load_plugin("heat"), PluginError);
}

}  // namespace
}  // namespace hawser
