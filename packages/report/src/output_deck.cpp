#include "hawser/report/output_deck.hpp"

namespace hawser {

Spec<OutputDeck> OutputDeck::spec() {
  using P = OutputDeck;
  return Spec<P>("output", "What is written, and how often.")
      .attribute("fields-every", &P::fields_every, at_least(0),
                 "Steps between outputs of the fields; 0 for the end only.")
      .attribute("history-every", &P::history_every, at_least(1),
                 "Steps between rows of the histories.")
      .attribute("checkpoint-every", &P::checkpoint_every, at_least(0),
                 "Steps between checkpoints; 0 for none.")
      .attribute("checkpoint-at-end", &P::checkpoint_at_end,
                 "One more at the end, for another run to start from.")
      .any_children(&P::reports, "reports")
      .location(&P::location);
}

Spec<ExpectDeck> ExpectDeck::spec() {
  using P = ExpectDeck;
  return Spec<P>("expect", "A reported quantity that must come out; otherwise the exit code is 8.")
      .attribute("quantity", &P::quantity, required(), "Name in summary.json.")
      .attribute("value", &P::value, "as the quantity", required() && any(), "What is expected.")
      .attribute("within", &P::within, "as the quantity", required() && non_negative(),
                 "Allowed difference.")
      .attribute("why", &P::why, required(), "Where the value comes from.");
}

}  // namespace hawser
