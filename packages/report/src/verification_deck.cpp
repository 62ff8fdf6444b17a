#include "hawser/report/verification_deck.hpp"

namespace hawser {

Spec<OrderDeck> OrderDeck::spec() {
  using P = OrderDeck;
  return Spec<P>("order",
                 "The order with which a quantity must vanish between the two finest levels; "
                 "otherwise the exit code is 8.")
      .attribute("quantity", &P::quantity, required(), "Name in summary.json.")
      .attribute("at-least", &P::at_least, "1", required() && positive(), "Least order.")
      .attribute("why", &P::why, required(), "Where the order comes from.");
}

Spec<ConvergeDeck> ConvergeDeck::spec() {
  using P = ConvergeDeck;
  return Spec<P>("converge",
                 "How `hawser converge` refines this deck, and what it expects; a plain run takes "
                 "no notice.")
      .choice(
          "refine", &P::refine,
          {{"space", Refinement::space}, {"time", Refinement::time}, {"both", Refinement::both}},
          "What each level halves: the mesh's cells, the time step, or both.")
      .attribute("levels", &P::levels, between(2, 12),
                 "How many runs; the first is the deck as it stands.")
      .children(&P::orders);
}

}  // namespace hawser
