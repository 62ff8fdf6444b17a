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
  /// Of the last accepted state. The last two are kept. Returns the file's name.
  std::string save_checkpoint(Stepper& stepper);
  /// The same of a state that the stepper was in.
  void save_checkpoint(const Stepper& stepper, Checkpoint state);
  /// The last one that is known to be good; empty when there is none.
  std::string kept_checkpoint() const { return kept_step_ >= 0 ? file() : ""; }
  int kept_step() const { return kept_step_; }  ///< -1 when there is none

  double seconds() const { return watch_.seconds(); }  ///< spent on writing

 private:
  std::string file() const { return folder_.file("checkpoint.h5"); }
  /// Where the present one goes when the next is written; one that is damaged must not take the
  /// place of the one before it, which is not.
  std::string place_of_present() const {
    return kept_step_ >= 0 ? previous_checkpoint(file()) : "";
  }

  const ResultFolder& folder_;
  RunLog& log_;
  FieldOutput fields_;
  Stopwatch watch_;
  int kept_step_ = -1;  // of the file with the name of a checkpoint; -1: it is none, or damaged
};

}  // namespace hawser
