#pragma once
// What happens in a run, told as it happens: to a person (ConsoleLog) or to a program (JsonLog).
#include <memory>
#include <string>

#include "hawser/output/summary.hpp"
#include "hawser/report/expectations.hpp"
#include "hawser/simulation/simulation.hpp"
#include "src/system.hpp"

namespace hawser {

/// Called on all ranks; rank 0 tells, on standard output.
class RunLog {
 public:
  virtual ~RunLog() = default;
  virtual void note(const std::string& sentence) = 0;
  virtual void start(const System& system, const RunDeck& deck, const std::string& folder) = 0;
  /// Newton's method for the step that is told next.
  virtual void solved(const NonlinearReport& report) = 0;
  virtual void rejected(double time, double length, const std::string& why) = 0;
  virtual void stepped(const Step& step, const MeshFigures& mesh, double end) = 0;
  /// `what` is "fields" or "checkpoint".
  virtual void wrote(const std::string& what, int step, double time) = 0;
  /// `closing`: what the reports say at the end.
  virtual void finish(const std::string& closing, const std::vector<Judgement>& judgements,
                      const Summary& summary) = 0;
};

std::unique_ptr<RunLog> make_run_log(const Communicator& communicator, const RunOptions& options);

}  // namespace hawser
