// What a run tells, word for word.
#include "hawser/log/run_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hawser {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

const RunHeading heading{"A tow", "results/tow", 2, 418, 2099, {"ale-fluid", "cable"}, 0, 100};

NonlinearReport solved() {
  NonlinearReport report;
  report.converged = true;
  report.iterations = 2, report.linear_iterations = 17, report.jacobians = 2;
  report.factorizations = 1;
  report.history = {{{"fluid", "velocity", "N/m", 3.2, 10, 0.32}},
                    {{"fluid", "velocity", "N/m", 4e-9, 10, 4e-10}}};
  report.criteria = {{"fluid", "velocity", "residual", 0.32, 1e-8},
                     {"fluid", "velocity", "residual", 4e-10, 1e-8}};
  return report;
}

/// A whole run as the log tells it on standard output; its errors go to `errors`.
std::string told(LogDetail detail, bool json, std::string* errors = nullptr) {
  State state;
  state.time = 20;
  const std::vector<double> reactions;
  const Step step{3, 10, false, std::nullopt, 2, 17, state, state, reactions};
  Judgement met{{{"end_error_m", {"tow.xml", 7, 3}}, 154, 1, "as measured"}, 154.5, true};
  Judgement missed{{{"no_such", {"tow.xml", 8, 3}}, 1, 0.5, "a test"}, std::nullopt, false};
  Summary summary;
  summary.set("end_error_m", 154.5);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  {
    const auto log = make_run_log(Communicator(MPI_COMM_SELF), detail, json);
    log->note("made 418 nodes");
    log->start(heading);
    log->solved(solved());
    log->rejected(10, 20, "no convergence");
    log->stepped(step, {0.73, 0.25}, heading.end);
    log->wrote("fields", 3, 20);
    log->finish("end error 154.5 m\n", {met, missed}, summary);
  }
  const std::string said = testing::internal::GetCapturedStderr();
  if (errors != nullptr) *errors = said;
  return testing::internal::GetCapturedStdout();
}

TEST(ConsoleLog, TellsARunInSentences) {
  std::string errors;
  const std::string text = told(LogDetail::steps, false, &errors);
  EXPECT_THAT(text, HasSubstr("made 418 nodes\nA tow\n"
                              "418 nodes, 2099 unknowns, 2 rank(s); modules: ale-fluid, cable\n"));
  EXPECT_THAT(text, HasSubstr("step of 20 s from t = 10 s rejected: no convergence\n"));
  EXPECT_THAT(text, HasSubstr("step    3  t      20 s  dt 10 s  Newton 2 linear  17  decides "
                              "fluid.velocity residual 4.0e-10 of 1e-08  quality 0.73  Courant "
                              "0.25  wall "));
  EXPECT_THAT(text, Not(HasSubstr("iteration  0")));
  EXPECT_THAT(text, HasSubstr("end error 154.5 m\n"
                              "tow.xml:7:3: expected end_error_m = 154 +- 1 (as measured); got "
                              "154.5: holds\n"
                              "results: results/tow\n"));
  EXPECT_EQ(errors,
            "tow.xml:8:3: expected no_such = 1 +- 0.5 (a test); got nothing: the run reports no "
            "such quantity: FAILS\n");
}

TEST(ConsoleLog, QuietTellsWhatWentWrongOnly) {
  std::string errors;
  EXPECT_EQ(told(LogDetail::quiet, false, &errors),
            "step of 20 s from t = 10 s rejected: no convergence\n");
  EXPECT_EQ(errors,
            "tow.xml:8:3: expected no_such = 1 +- 0.5 (a test); got nothing: the run reports no "
            "such quantity: FAILS\n");
}

// The last step may end beyond the end by round-off.
TEST(ConsoleLog, NothingIsLeftAtTheEnd) {
  State state;
  state.time = 100 * (1 + 1e-15);
  const std::vector<double> reactions;
  const Step step{3, 10, true, std::nullopt, 2, 17, state, state, reactions};
  testing::internal::CaptureStdout();
  make_run_log(Communicator(MPI_COMM_SELF), LogDetail::steps, false)
      ->stepped(step, {0.73, 0.25}, 100);
  EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("left 0 s\n"));
}

TEST(ConsoleLog, VerboseTellsIterationsAndOutputs) {
  const std::string text = told(LogDetail::iterations, false);
  EXPECT_THAT(text, HasSubstr("  iteration  0  decides fluid.velocity residual 3.2e-01 of 1e-08\n"
                              "    fluid.velocity           residual 3.2e+00 N/m    ratio 3.2e-01\n"
                              "  iteration  1  decides fluid.velocity residual 4.0e-10 of 1e-08\n"
                              "    fluid.velocity           residual 4.0e-09 N/m    ratio 4.0e-10\n"
                              "  2 Jacobian(s), 1 factor(s)\n"));
  EXPECT_THAT(text, HasSubstr("  wrote fields of step 3, t = 20 s\n"));
}

TEST(JsonLog, TellsOneObjectPerLine) {
  const std::string text = told(LogDetail::steps, true);
  EXPECT_THAT(text, HasSubstr(R"({"event":"note","text":"made 418 nodes"})"));
  EXPECT_THAT(text, HasSubstr(R"("folder":"results/tow","ranks":2,"nodes":418,"unknowns":2099,)"
                              R"("modules":["ale-fluid","cable"],"time_s":0.0,"end_s":100.0})"));
  EXPECT_THAT(text, HasSubstr(R"({"event":"rejected","time_s":10.0,"step_s":20.0,)"
                              R"("reason":"no convergence"})"));
  EXPECT_THAT(text, HasSubstr(R"("newton_iterations":2,"linear_iterations":17,"jacobians":2,)"
                              R"("factorizations":1,"decides":{"block":"fluid","field":"velocity",)"
                              R"("test":"residual","value":4e-10,"tolerance":1e-08},)"
                              R"("residuals":[{"block":"fluid","field":"velocity",)"
                              R"("residual":4e-09,"unit":"N/m","ratio":4e-10,"error":null}])"));
  EXPECT_THAT(text, HasSubstr(R"("summary":{"end_error_m":154.5}})"));
}

TEST(RunLog, OtherRanksSayNothing) {
  const Communicator world;
  testing::internal::CaptureStdout();
  make_run_log(world, LogDetail::steps, false)->note("one voice");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), world.is_root() ? "one voice\n" : "");
}

}  // namespace
}  // namespace hawser
