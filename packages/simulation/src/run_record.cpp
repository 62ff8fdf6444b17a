#include "src/run_record.hpp"

#include "hawser/output/provenance.hpp"
#include "hawser/time/state_checkpoint.hpp"

namespace hawser {
namespace {

/// The state from which a run steps on.
State state_of(const TimeHistory& history) {
  State state;
  state.time = history.time;
  state.value = state.accepted = history.value;
  state.rate = history.rate;
  state.rate_slope.assign(history.value.size(), 0);
  state.rate_partner.assign(history.value.size(), 0);
  return state;
}

}  // namespace

RunRecord::RunRecord(System& system, const RunCase& run, const ResultFolder& folder,
                     const std::string& mesh_file, RunLog& log, const CheckpointReader* earlier)
    : system_(system),
      run_(run),
      folder_(folder),
      log_(log),
      mesh_file_(std::filesystem::absolute(mesh_file)),
      step_(earlier ? earlier->header().step : 0),
      fields_(*system.assembler, system.modules, system.reports->all(), folder.path(),
              earlier ? step_ : -1) {
  if (earlier) system.reports->resume(earlier->header());
  const State state = state_of(system.integrator->history());
  system.reports->start({folder.path(), state, earlier != nullptr});
}

void RunRecord::accepted(const Step& step) {
  step_ = step.number;
  last_.emplace(step);
  system_.reports->accepted(step);
}

void RunRecord::write(const StepControl& steps) {
  const auto lap = watch_.lap();
  const OutputDeck& output = run_.deck.output;
  const auto due = [&](int every) { return every > 0 && step_ % every == 0; };
  const bool fields_due = due(output.fields_every) || last_->last;
  if (fields_due && fields_.writes()) {
    fields_.write(step_, last_->end);
    log_.wrote("fields", step_, last_->end.time);
  }
  system_.reports->write(*last_, due(output.history_every) || last_->last, fields_due);
  if (due(output.checkpoint_every)) save_checkpoint(steps);
}

Summary RunRecord::summary() const {
  Summary result;
  result.set("title", run_.deck.title);
  system_.reports->summarise(*last_, result);
  return result;
}

std::string RunRecord::save_checkpoint(const StepControl& steps) {
  CheckpointHeader header;
  header.step = step_;
  header.numbers["control_step_s"] = steps.step();
  header.numbers["control_successes"] = steps.successes();
  system_.reports->save(header);
  header.texts["deck"] = run_.text.text;
  header.texts["deck_file"] = run_.text.file;
  Summary provenance;
  add_provenance(system_.mesh.communicator, provenance);
  header.texts["provenance"] = provenance.object("provenance").json();
  // A mesh beside the checkpoint is named without its folder, so that both can be moved.
  const bool beside = mesh_file_.parent_path() == std::filesystem::absolute(folder_.path());
  header.texts["mesh"] = (beside ? mesh_file_.filename() : mesh_file_).string();
  std::string path = folder_.file("checkpoint.h5");
  save_history(*system_.dofs, system_.integrator->history(), header, path);
  system_.driver->forget();
  log_.wrote("checkpoint", step_, system_.integrator->history().time);
  return path;
}

}  // namespace hawser
