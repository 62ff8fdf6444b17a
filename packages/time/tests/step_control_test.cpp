#include "hawser/time/step_control.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hawser {
namespace {

using testing::DoubleNear;
using testing::Pointwise;

StepOptions options() {
  StepOptions result;
  result.step = 20, result.least = 2, result.end = 100, result.grow_after = 2;
  return result;
}

std::vector<double> times(const StepControl& steps) {
  std::vector<double> result;
  for (double t = 0, previous = 0; !steps.finished(t); result.push_back(t)) {
    previous = steps.next(t, previous);
    t += previous;
  }
  return result;
}

TEST(StepControl, EndsStepsOnEventsAndOnTheEnd) {
  StepControl steps(options(), {30, 70});
  EXPECT_EQ(times(steps), (std::vector<double>{15, 30, 50, 70, 85, 100}));
}

TEST(StepControl, SplitsWhatRemainsToAnEventEvenly) {
  StepControl steps(options(), {40.001, 41});
  // 20 s, then half of 20.001 s each; after the second event the steps double from its 0.999 s.
  EXPECT_THAT(times(steps), Pointwise(DoubleNear(1e-9), {20.0, 30.0005, 40.001, 41.0, 42.998,
                                                         46.994, 54.986, 70.97, 85.485, 100.0}));
}

TEST(StepControl, DoesNotLeaveARemainderOfRoundOff) {
  StepOptions tenth;
  tenth.step = 0.1, tenth.end = 1;
  StepControl steps(tenth, {});
  int taken = 0;
  for (double t = 0; !steps.finished(t); ++taken)
    t += steps.next(t, 0);
  EXPECT_EQ(taken, 10);  // although ten times 0.1 is less than 1 in floating point
}

TEST(StepControl, PassesAnEventOnce) {
  StepControl steps(options(), {20});
  EXPECT_EQ(steps.next(20 - 1e-12, 20), 20);
}

TEST(StepControl, HalvesARejectedStepAndGrowsAgain) {
  StepControl steps(options(), {});
  EXPECT_TRUE(steps.rejected(20));
  EXPECT_EQ(steps.next(0, 0), 10);
  EXPECT_TRUE(steps.rejected(10));
  EXPECT_EQ(steps.next(0, 0), 5);
  for (const double wanted : {5.0, 10.0, 10.0, 20.0, 20.0}) {
    steps.accepted(0, {});
    EXPECT_EQ(steps.step(), wanted);
  }
}

TEST(StepControl, ARejectionStartsTheCountAgain) {
  StepControl steps(options(), {});
  steps.rejected(20);
  steps.accepted(0, {});
  steps.rejected(10);
  steps.accepted(0, {});
  EXPECT_EQ(steps.step(), 5);
}

TEST(StepControl, GivesUpBelowTheLeastStep) {
  StepControl steps(options(), {});
  EXPECT_TRUE(steps.rejected(20));    // 10
  EXPECT_TRUE(steps.rejected(10));    // 5
  EXPECT_TRUE(steps.rejected(5));     // 2.5
  EXPECT_FALSE(steps.rejected(2.5));  // 1.25 would be less than 2
  EXPECT_EQ(steps.step(), 2.5);
}

TEST(StepControl, HalvesWhatWasAttemptedNotWhatWasWanted) {
  StepControl steps(options(), {8});
  EXPECT_EQ(steps.next(0, 0), 8);
  EXPECT_TRUE(steps.rejected(8));
  EXPECT_EQ(steps.next(0, 0), 4);
}

TEST(StepControl, ResumesWithStepAndCountOfACheckpoint) {
  StepControl steps(options(), {});
  steps.resume(5, 1);
  EXPECT_EQ(steps.next(0, 0), 5);
  steps.accepted(0, {});  // the second in a row
  EXPECT_EQ(steps.step(), 10);
}

StepControl steered(const StepTargets& targets, int order = 2) {
  StepOptions options;
  options.step = 1, options.least = 0.01, options.end = 1000;
  options.targets = targets, options.order = order;
  return StepControl(options, {});
}

TEST(SteeredSteps, FollowTheLocalError) {
  StepTargets targets;
  targets.error = 1e-3;
  StepControl steps = steered(targets);
  steps.accepted(1, {});  // nothing known yet: as it is
  EXPECT_EQ(steps.step(), 1);
  steps.accepted(1, {1e-9, 1});  // at most doubled
  EXPECT_EQ(steps.step(), 2);
  steps.accepted(2, {1e-3 / 4.096, 1});  // the third root of 4.096 is 1.6
  EXPECT_NEAR(steps.step(), 2 * 0.9 * 1.6, 1e-12);
  EXPECT_FALSE(steps.is_too_inaccurate({1e-3, 1}));
  EXPECT_TRUE(steps.is_too_inaccurate({1.1e-3, 1}));
  EXPECT_TRUE(steps.rejected(2, {8e-3, 1}));  // the third root of 8 is 2
  EXPECT_NEAR(steps.step(), 2 * 0.9 / 2, 1e-12);
  EXPECT_TRUE(steps.rejected(2));  // Newton failed: halved
  EXPECT_EQ(steps.step(), 1);
}

TEST(SteeredSteps, OfAFirstOrderSchemeGoWithTheSquareRoot) {
  StepTargets targets;
  targets.error = 1e-3;
  StepControl steps = steered(targets, 1);
  steps.accepted(1, {1e-3 / 2.25, 1});
  EXPECT_NEAR(steps.step(), 0.9 * 1.5, 1e-12);
}

TEST(SteeredSteps, FollowNewtonsEffortAndTheLimits) {
  StepTargets targets;
  targets.newton_iterations = 4, targets.longest = 1.5;
  StepControl steps = steered(targets);
  steps.accepted(1, {1e-3, 2});
  EXPECT_EQ(steps.step(), 1.5);
  steps.accepted(1.5, {1e-3, 4});  // as wanted: as it is
  EXPECT_EQ(steps.step(), 1.5);
  steps.accepted(1, {1e-3, 8});
  EXPECT_EQ(steps.step(), 0.5);
  for (int n = 0; n < 10; ++n)
    steps.accepted(steps.step(), {1e-3, 8});
  EXPECT_EQ(steps.step(), 0.01);
}

}  // namespace
}  // namespace hawser
