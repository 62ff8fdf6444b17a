#pragma once
// What a run leaves in its result folder while it steps: reports, fields, checkpoints.
#include <filesystem>
#include <optional>

#include "hawser/base/stopwatch.hpp"
#include "hawser/output/result_folder.hpp"
#include "hawser/report/field_output.hpp"
#include "hawser/time/step_control.hpp"
#include "src/run_log.hpp"

namespace hawser {

class RunRecord {
 public:
  /// Goes on from `earlier` unless that is null. All members are collective; OutputError on all
  /// ranks. The references must outlive the record.
  RunRecord(System& system, const RunCase& run, const ResultFolder& folder,
            const std::string& mesh_file, RunLog& log, const CheckpointReader* earlier);

  void rejected() { system_.reports->rejected(); }
  /// Measures an accepted step.
  void accepted(const Step& step);
  /// What is due after that step.
  void write(const StepControl& steps);
  /// The last accepted state; returns the file's name. A restarted run begins without a Jacobian or
  /// factor; to be equal to it, this one goes on without them, too.
  std::string save_checkpoint(const StepControl& steps);

  int step() const { return step_; }  ///< number of the last accepted step
  Summary summary() const;
  double seconds() const { return watch_.seconds(); }  ///< spent on writing

 private:
  System& system_;
  const RunCase& run_;
  const ResultFolder& folder_;
  RunLog& log_;
  std::filesystem::path mesh_file_;
  int step_;
  FieldOutput fields_;
  std::optional<Step> last_;
  Stopwatch watch_;
};

}  // namespace hawser
