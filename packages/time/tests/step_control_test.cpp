#include "hawser/time/step_control.hpp"

#include <gtest/gtest.h>

namespace hawser {
namespace {

StepOptions options() {
  StepOptions result;
  result.step = 20, result.least = 2, result.end = 100, result.grow_after = 2;
  return result;
}

TEST(StepControl, EndsStepsOnEventsAndOnTheEnd) {
  StepControl steps(options(), {30, 70});
  std::vector<double> times;
  for (double t = 0; !steps.finished(t); times.push_back(t))
    t += steps.next(t);
  EXPECT_EQ(times, (std::vector<double>{20, 30, 50, 70, 90, 100}));
}

TEST(StepControl, DoesNotLeaveARemainderOfRoundOff) {
  StepOptions tenth;
  tenth.step = 0.1, tenth.end = 1;
  StepControl steps(tenth, {});
  int taken = 0;
  for (double t = 0; !steps.finished(t); ++taken)
    t += steps.next(t);
  EXPECT_EQ(taken, 10);  // although ten times 0.1 is less than 1 in floating point
}

TEST(StepControl, PassesAnEventOnce) {
  StepControl steps(options(), {20});
  EXPECT_EQ(steps.next(20 - 1e-12), 20);
}

TEST(StepControl, HalvesARejectedStepAndGrowsAgain) {
  StepControl steps(options(), {});
  EXPECT_TRUE(steps.rejected());
  EXPECT_EQ(steps.next(0), 10);
  EXPECT_TRUE(steps.rejected());
  EXPECT_EQ(steps.next(0), 5);
  for (const double wanted : {5.0, 10.0, 10.0, 20.0, 20.0}) {
    steps.accepted();
    EXPECT_EQ(steps.step(), wanted);
  }
}

TEST(StepControl, ARejectionStartsTheCountAgain) {
  StepControl steps(options(), {});
  steps.rejected();
  steps.accepted();
  steps.rejected();
  steps.accepted();
  EXPECT_EQ(steps.step(), 5);
}

TEST(StepControl, GivesUpBelowTheLeastStep) {
  StepControl steps(options(), {});
  EXPECT_TRUE(steps.rejected());   // 10
  EXPECT_TRUE(steps.rejected());   // 5
  EXPECT_TRUE(steps.rejected());   // 2.5
  EXPECT_FALSE(steps.rejected());  // 1.25 would be less than 2
  EXPECT_EQ(steps.step(), 2.5);
}

TEST(StepControl, ResumesWithStepAndCountOfACheckpoint) {
  StepControl steps(options(), {});
  steps.resume(5, 1);
  EXPECT_EQ(steps.next(0), 5);
  steps.accepted();  // the second in a row
  EXPECT_EQ(steps.step(), 10);
}

}  // namespace
}  // namespace hawser
