// A stepper steps as the deck says, tells who looks on, and writes nothing by itself.
#include "hawser/simulation/stepper.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numeric>

#include "hawser/base/error.hpp"
#include "hawser/simulation/run.hpp"
#include "hawser/simulation/run_deck.hpp"
#include "sample_deck.hpp"

namespace hawser {
namespace {

struct Attempts : Observer {
  std::vector<Attempt> all;
  void attempted(Stepper& stepper, const Attempt& attempt) override {
    EXPECT_EQ(stepper.time(), attempt.time);
    all.push_back(attempt);
  }
};

class StepperTest : public testing::Test {
 protected:
  Case string(const std::vector<DeckChange>& changes = {}) {
    return Case::from_text(environment_, sample_deck, "string.xml", {changes, {}, true});
  }
  /// Where a run of the deck ends: the middle's height, m.
  double height_at_the_end(const Case& run_case) {
    Stepper stepper(run_case);
    step_to_the_end(stepper);
    return *stepper.quantity("middle_displacement_y_m");
  }
  Environment environment_;
};

TEST_F(StepperTest, TakesTheStepsOfTheDeckAndTellsThem) {
  Attempts attempts;
  Stepper stepper(string());
  stepper.observe(attempts);
  EXPECT_EQ(stepper.time(), 0);
  EXPECT_EQ(stepper.quantity("t_s"), std::nullopt);
  step_to_the_end(stepper);
  ASSERT_EQ(attempts.all.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_TRUE(attempts.all[i].accepted);
    EXPECT_NEAR(attempts.all[i].time, 0.01 * static_cast<double>(i + 1), 1e-12);
    EXPECT_GE(attempts.all[i].newton.iterations, 1);
  }
  EXPECT_EQ(stepper.steps(), 6);
  EXPECT_NEAR(*stepper.quantity("t_s"), 0.06, 1e-12);
}

TEST_F(StepperTest, GivesFieldsByNameWithEachNodeOnce) {
  Stepper stepper(string());
  const FieldValues before = stepper.field("displacement");
  EXPECT_EQ(before.unit, "m");
  EXPECT_EQ(before.components, 2);
  ASSERT_EQ(before.values.size(), 2 * before.ids.size());
  for (std::size_t i = 0; i < before.ids.size(); ++i) {
    const double x = before.positions[2 * i];
    EXPECT_NEAR(before.values[2 * i], 0.005 * x, 1e-15);
    EXPECT_NEAR(before.values[2 * i + 1], 0.005 * std::sin(std::acos(-1) * x / 10), 1e-15);
  }
  const Communicator& all = environment_.communicator();
  EXPECT_EQ(all.sum(static_cast<long long>(before.ids.size())), 11);
  EXPECT_EQ(all.sum(std::accumulate(before.ids.begin(), before.ids.end(), 0LL)), 55);
  EXPECT_THROW(stepper.field("displacment"), DeckError);
}

TEST_F(StepperTest, ARejectedStepIsToldAndTheNextIsShorter) {
  Attempts attempts;
  Stepper stepper(string({{"amplitude", "2"},
                          {"solver/newton/max-iterations", "1"},
                          {"solver/newton/lagged", "false"},
                          {"time/least-step", "0.005"}}));
  stepper.observe(attempts);
  const Attempt first = stepper.advance();
  EXPECT_FALSE(first.accepted);
  EXPECT_FALSE(first.why.empty());
  EXPECT_EQ(first.time, 0);
  EXPECT_THROW(stepper.advance(), SolveError);
  ASSERT_EQ(attempts.all.size(), 2u);
  EXPECT_NEAR(attempts.all[1].length, 0.005, 1e-15);
  EXPECT_EQ(stepper.time(), 0);
}

TEST_F(StepperTest, APartnerMaySetThePace) {
  Stepper stepper(string());
  EXPECT_EQ(stepper.advance(0.004).length, 0.004);
  EXPECT_EQ(stepper.time(), 0.004);
}

TEST_F(StepperTest, ACaseMakesAnyNumberOfSteppersAndPreviews) {
  const Case run_case = string();
  const std::string text = preview(run_case);
  if (environment_.communicator().is_root()) {
    EXPECT_THAT(text, testing::HasSubstr("44 in all, on 11 nodes"));
  }
  EXPECT_EQ(height_at_the_end(run_case), height_at_the_end(run_case));
}

TEST_F(StepperTest, RunsTwiceToTheSameEnd) {
  const Case run_case = string();
  RunOptions options;
  options.detail = LogDetail::quiet;
  options.force = true;
  for (const char* folder : {"first", "second"}) {
    options.output = folder;
    const Summary summary = run(run_case, options);
    EXPECT_EQ(summary.number("middle_displacement_y_m"), height_at_the_end(run_case));
    EXPECT_TRUE(std::filesystem::exists(std::string(folder) + "/summary.json"));
  }
}

TEST_F(StepperTest, GoesOnFromWhatItSaved) {
  Stepper stepper(string());
  for (int i = 0; i < 3; ++i)
    stepper.advance();
  stepper.save("half.h5");
  for (const char* path : {"amplitude", "time/scheme", "modules/cable/mass-per-length"})
    EXPECT_THAT(
        [&] {
          Case::from_checkpoint(environment_, "half.h5", {{{path, "1"}}, {}, true});
        },
        testing::ThrowsMessage<DeckError>(testing::HasSubstr("a run that goes on keeps its ")));
  Stepper second(Case::from_checkpoint(environment_, "half.h5"));
  EXPECT_EQ(second.steps(), 3);
  EXPECT_EQ(second.time(), stepper.time());
  EXPECT_EQ(second.field("displacement").values, stepper.field("displacement").values);
  step_to_the_end(stepper);
  step_to_the_end(second);
  EXPECT_EQ(second.quantities(), stepper.quantities());
}

TEST_F(StepperTest, MayChangeItsStepAndItsEndOnTheWay) {
  const Case run_case = string();
  const double end = run_case.deck().time.end, step = run_case.deck().time.step;
  Stepper stepper(run_case);
  stepper.advance();
  stepper.save("changing.h5");
  const CaseOptions longer{{{"time/step", write_value(step / 2)}}, 2 * end, true};
  Stepper second(Case::from_checkpoint(environment_, "changing.h5", longer));
  EXPECT_EQ(second.run_case().deck().time.end, 2 * end);
  EXPECT_NEAR(second.advance().length, step / 2, 1e-12 * step);
  second.save("changed.h5");
  // What was changed once stays so, and is to be read in the deck.
  const Case third = Case::from_checkpoint(environment_, "changed.h5");
  EXPECT_EQ(third.end(), 2 * end);
  EXPECT_THAT(third.resolved_deck(), testing::HasSubstr("end=\"" + write_value(2 * end) + "\""));
  EXPECT_EQ(third.deck().time.step, step / 2);
  EXPECT_EQ(Case::from_checkpoint(environment_, "changed.h5",
                                  {{{"time/end", write_value(3 * end)}}, {}, true})
                .deck()
                .time.end,
            3 * end);
}

TEST_F(StepperTest, StepsOnAnAdoptedCommunicator) {
  const Environment alone(MPI_COMM_SELF);  // each rank for itself
  Stepper stepper(Case::from_text(alone, sample_deck));
  EXPECT_EQ(stepper.field("displacement").ids.size(), 11u);
  step_to_the_end(stepper);
  EXPECT_NEAR(*stepper.quantity("middle_displacement_y_m"), height_at_the_end(string()), 1e-12);
}

TEST_F(StepperTest, WritesNothingByItself) {
  const auto count = [] { return std::distance(std::filesystem::directory_iterator("empty"), {}); };
  environment_.communicator().on_root([] { std::filesystem::create_directory("empty"); });
  const auto home = std::filesystem::current_path();
  std::filesystem::current_path("empty");
  {
    Stepper stepper(string());
    step_to_the_end(stepper);
  }
  std::filesystem::current_path(home);
  EXPECT_EQ(count(), 0);
}

}  // namespace
}  // namespace hawser
