#pragma once
// What a run leaves in its result folder while it steps: histories, fields, checkpoints, and the
// figures that its summary is made of.
#include <filesystem>
#include <memory>

#include "hawser/base/stopwatch.hpp"
#include "hawser/output/result_folder.hpp"
#include "hawser/time/step_control.hpp"
#include "src/field_output.hpp"
#include "src/run_case.hpp"
#include "src/run_log.hpp"
#include "src/run_summary.hpp"
#include "src/system.hpp"

namespace hawser {

class RunRecord {
 public:
  /// Goes on from `earlier` unless that is null. All members are collective; OutputError on all
  /// ranks. The references must outlive the record.
  RunRecord(System& system, const RunCase& run, const ResultFolder& folder,
            const std::string& mesh_file, RunLog& log, const CheckpointReader* earlier);

  void rejected() { figures_.rejected(); }
  /// Takes an accepted step into account, numbers and measures it.
  void accepted(StepFigures& figures);
  /// What is due after that step.
  void write(const StepFigures& figures, const StepControl& steps, bool last);
  /// The last accepted state; returns the file's name. A restarted run begins without a Jacobian or
  /// factor; to be equal to it, this one goes on without them, too.
  std::string save_checkpoint(const StepControl& steps);

  Summary summary() const { return figures_.summary(system_, run_.deck); }
  double seconds() const { return watch_.seconds(); }  ///< spent on writing

 private:
  System& system_;
  const RunCase& run_;
  const ResultFolder& folder_;
  RunLog& log_;
  std::filesystem::path mesh_file_;
  int step_;
  FieldOutput fields_;
  Histories histories_;
  RunSummary figures_;
  Stopwatch watch_;
};

}  // namespace hawser
