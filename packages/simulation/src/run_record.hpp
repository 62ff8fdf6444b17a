#pragma once
// What a run leaves in its result folder while it steps: reports, fields, checkpoints.
#include "hawser/base/stopwatch.hpp"
#include "hawser/log/run_log.hpp"
#include "hawser/output/result_folder.hpp"
#include "hawser/report/field_output.hpp"
#include "hawser/simulation/stepper.hpp"
#include "src/system.hpp"

namespace hawser {

class RunRecord : public Observer {
 public:
  /// Goes on from the case's checkpoint, if it has one. All members are collective; OutputError on
  /// all ranks. The references must outlive the record.
  RunRecord(Stepper& stepper, const ResultFolder& folder, RunLog& log);

  /// What is due after an accepted step.
  void attempted(Stepper& stepper, const Attempt& attempt) override;
  /// Returns the file's name.
  std::string save_checkpoint(Stepper& stepper);

  double seconds() const { return watch_.seconds(); }  ///< spent on writing

 private:
  const ResultFolder& folder_;
  RunLog& log_;
  FieldOutput fields_;
  Stopwatch watch_;
};

}  // namespace hawser
