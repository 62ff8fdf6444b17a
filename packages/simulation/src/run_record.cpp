#include "src/run_record.hpp"

#include "hawser/output/provenance.hpp"
#include "hawser/time/state_checkpoint.hpp"
#include "src/mesh_monitor.hpp"

namespace hawser {
namespace {

void measure(const System& system, StepFigures& result) {
  const State& state = system.problem->end();
  const State& balance = system.problem->state();
  result.time = state.time;
  result.balance_time = balance.time;
  result.length = system.integrator->history().step;
  const MeshFigures mesh = inspect_mesh(*system.dofs, state);
  result.mesh_quality = mesh.least_quality;
  result.courant = mesh.courant;
  if (system.tow) result.tow = system.tow->measure(state, system.problem->reactions());
  for (const ForceReport& force : system.forces)
    result.forces.push_back(force.measure(balance, system.problem->reactions()));
  for (const Probe& probe : system.probes)
    for (int c = 0; c < probe.components; ++c)
      result.probes.push_back(system.mesh.communicator.sum(
          probe.first_row < 0 ? 0.0 : state.value[static_cast<std::size_t>(probe.first_row + c)]));
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
      fields_(*system.assembler, system.tow.get(), folder.path(), earlier ? step_ : -1),
      histories_(system.mesh, folder.path(), system.tow.get(), system.forces, system.probes,
                 earlier ? std::optional<double>(earlier->header().time) : std::nullopt) {
  if (earlier) figures_.resume(earlier->header());
  if (system.receivers)
    system.receivers->open(folder.path(), system.integrator->history(), earlier != nullptr);
}

void RunRecord::accepted(StepFigures& figures) {
  figures.step = ++step_;
  measure(system_, figures);
  figures_.add(figures);
}

void RunRecord::write(const StepFigures& figures, const StepControl& steps, bool last) {
  const auto lap = watch_.lap();
  const State& state = system_.problem->end();
  const OutputDeck& output = run_.deck.output;
  const auto due = [&](int every) { return every > 0 && step_ % every == 0; };
  if (due(output.history_every) || last) histories_.append(figures);
  if (due(output.fields_every) || last) {
    fields_.write(step_, state);
    histories_.append_cable(state);
    log_.wrote("fields", step_, state.time);
  }
  if (system_.receivers) system_.receivers->stepped(state, step_, last);
  if (due(output.checkpoint_every)) save_checkpoint(steps);
}

std::string RunRecord::save_checkpoint(const StepControl& steps) {
  CheckpointHeader header;
  header.step = step_;
  header.numbers["control_step_s"] = steps.step();
  header.numbers["control_successes"] = steps.successes();
  figures_.save(header);
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
