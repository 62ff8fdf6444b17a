#include "src/take_over.hpp"

#include "hawser/simulation/run_deck.hpp"
#include "hawser/time/state_checkpoint.hpp"

namespace hawser {

void take_over(const Case& run_case, System& system) {
  const RunDeck& deck = run_case.deck();
  const Located<std::string>& from = *deck.start.from;
  const std::string file = path_beside(run_case.text(), from);
  State& state = system.problem->state();
  TakenFields fields;
  double time = 0;
  try {
    const CheckpointReader reader(run_case.communicator(), file);
    fields = take_fields(*system.dofs, reader, state);
    time = reader.header().time;
  } catch (const OutputError& error) {
    throw DeckError(from.location.text() + ": no start from " + file + ": " + error.what());
  }
  if (fields.taken.empty())
    throw DeckError(from.location.text() + ": " + file +
                    " has none of the fields of this run; it has " + listed(fields.unused));
  if (deck.start.continues_time) state.time = time;
  if (StepControl(deck.time, {}).finished(state.time))
    throw DeckError(from.location.text() + ": " + file + " is at t = " + write_value(time) +
                    " s, and the run ends at " + write_value(deck.time.end) +
                    " s: give <time> a later end, or begin at zero");
  system.notes.push_back("start: " + listed(fields.taken) + " from " + file +
                         ", t = " + write_value(time) + " s");
  if (!fields.absent.empty())
    system.notes.push_back("start: initial values for " + listed(fields.absent) +
                           ", which are not there");
  if (!fields.unused.empty())
    system.notes.push_back("start: nothing here solves for " + listed(fields.unused) +
                           ", which are there");
}

}  // namespace hawser
