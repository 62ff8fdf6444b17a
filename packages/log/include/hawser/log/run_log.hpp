#pragma once
// What happens in a run, told as it happens: to a person (ConsoleLog) or to a program (JsonLog).
#include <memory>
#include <string>

#include "hawser/output/summary.hpp"
#include "hawser/report/expectations.hpp"
#include "hawser/report/mesh_monitor.hpp"
#include "hawser/report/report.hpp"
#include "hawser/solve/nonlinear_driver.hpp"

namespace hawser {

enum class LogDetail {
  quiet,      ///< what went wrong only
  steps,      ///< a line per step
  iterations  ///< and one per Newton iteration and output
};

/// What a run is, before its first step.
struct RunHeading {
  std::string title, folder;  ///< of the deck; of the results
  int ranks = 1;
  long long nodes = 0, unknowns = 0;
  std::vector<std::string> modules;
  double time = 0, end = 0;  ///< s, at which it begins and is to end
};

/// Called on all ranks; rank 0 tells, on standard output. This one says nothing.
class RunLog {
 public:
  virtual ~RunLog() = default;
  virtual void note(const std::string& /*sentence*/) {}
  /// A note that is told even where nothing but what went wrong is.
  virtual void warn(const std::string& sentence) { note(sentence); }
  virtual void start(const RunHeading& /*heading*/) {}
  /// Newton's method for the step that is told next.
  virtual void solved(const NonlinearReport& /*report*/) {}
  virtual void rejected(double /*time*/, double /*length*/, const std::string& /*why*/) {}
  virtual void stepped(const Step& /*step*/, const MeshFigures& /*mesh*/, double /*end*/) {}
  /// `what` is "fields" or "checkpoint".
  virtual void wrote(const std::string& /*what*/, int /*step*/, double /*time*/) {}
  /// `closing`: what the reports say at the end.
  virtual void finish(const std::string& /*closing*/, const std::vector<Judgement>& /*judgements*/,
                      const Summary& /*summary*/) {}
};

/// Text for a person, or one JSON object per line.
std::unique_ptr<RunLog> make_run_log(const Communicator& communicator, LogDetail detail, bool json);

}  // namespace hawser
