#include "src/run_record.hpp"

#include <filesystem>

#include "hawser/simulation/run_deck.hpp"

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

RunRecord::RunRecord(Stepper& stepper, const ResultFolder& folder, RunLog& log)
    : folder_(folder),
      log_(log),
      fields_(*stepper.system().assembler, stepper.system().modules,
              stepper.system().reports->all(), folder.path(),
              stepper.run_case().checkpoint() ? stepper.steps() : -1) {
  const CheckpointReader* const from = stepper.run_case().checkpoint();
  const auto place = [](const std::string& path) {
    return std::filesystem::absolute(path).lexically_normal();
  };
  if (from != nullptr && place(from->path()) == place(file())) kept_step_ = from->header().step;
  const State state = state_of(stepper.system().integrator->history());
  stepper.system().reports->start(
      {folder.path(), state, stepper.run_case().checkpoint() != nullptr});
}

void RunRecord::attempted(Stepper& stepper, const Attempt& attempt) {
  if (!attempt.accepted) return;
  const auto lap = watch_.lap();
  const Step& step = stepper.last();
  const OutputDeck& output = stepper.run_case().deck().output;
  const auto due = [&](int every) { return every > 0 && step.number % every == 0; };
  const bool fields_due = due(output.fields_every) || step.last;
  if (fields_due && fields_.writes()) {
    fields_.write(step.number, step.end);
    log_.wrote("fields", step.number, step.end.time);
  }
  stepper.system().reports->write(step, due(output.history_every) || step.last, fields_due);
  if (due(output.checkpoint_every) || (step.last && output.checkpoint_at_end))
    save_checkpoint(stepper);
}

std::string RunRecord::save_checkpoint(Stepper& stepper) {
  stepper.save(file(), place_of_present());
  kept_step_ = stepper.steps();
  log_.wrote("checkpoint", stepper.steps(), stepper.time());
  return file();
}

void RunRecord::save_checkpoint(const Stepper& stepper, Checkpoint state) {
  const int step = state.header.step;
  stepper.save(std::move(state), file(), place_of_present());
  kept_step_ = step;
}

}  // namespace hawser
