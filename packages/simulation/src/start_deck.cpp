#include "hawser/simulation/start_deck.hpp"

namespace hawser {

Spec<EquilibriumDeck> EquilibriumDeck::spec() {
  using P = EquilibriumDeck;
  return Spec<P>("equilibrium",
                 "Solves for the steady state under the conditions and loads at the time of the "
                 "start; the run begins there, at rest.")
      .source("doc/decks.md, \"How a run starts\"")
      .attribute("tolerance", &P::tolerance, "1",
                 between(1e-15, 1e-1) && absent("that of <newton>"),
                 "Of Newton's method, as in <newton>.")
      .attribute("max-iterations", &P::max_iterations, at_least(1),
                 "Of Newton's method in one solve.")
      .attribute("relaxation-step", &P::relaxation_step, "s",
                 positive() && absent("the step of <time>"),
                 "Length of the first step of the relaxation that takes over where Newton's "
                 "method finds no steady state; later ones are longer or shorter by its effort.");
}

Spec<StartDeck> StartDeck::spec() {
  using P = StartDeck;
  return Spec<P>("start", "Where a run begins; without it, at the initial values.")
      .source("doc/decks.md, \"How a run starts\"")
      .attribute("from", &P::from, absent("from the initial values"),
                 "Checkpoint of another run on the same mesh, whose fields are the start; the deck "
                 "may differ. A relative path starts at the deck's folder.")
      .choice("time", &P::continues_time, {{"zero", false}, {"continued", true}},
              "The time at which the run begins: 0, or that of the checkpoint in `from`.")
      .child(&P::equilibrium)
      .location(&P::location)
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        if (p.continues_time && !p.from)
          diagnostics.error(where, "time=\"continued\" goes on from a checkpoint: give it in from");
      });
}

}  // namespace hawser
