#include "hawser/simulation/verification_deck.hpp"

namespace hawser {

Spec<ErrorDeck> ErrorDeck::spec() {
  using P = ErrorDeck;
  return Spec<P>("error",
                 "Reports the difference between a field and its exact solution at the end of the "
                 "run: NAME_error_l2, the root of its integrated square over the moved region (the "
                 "field's unit times m in a body, m^(1/2) on a line), and NAME_error_max.")
      .attribute("name", &P::name, required(), "Start of the quantities' names.")
      .attribute("field", &P::field, required(), "Field by name.")
      .attribute("on", &P::on, required(), "Region: a body or a line.")
      .attribute("exact", &P::exact, "SI", required() && any(),
                 "An expression per component, of x y z (moved), X Y Z (reference), t.")
      .attribute("up-to-constant", &P::up_to_constant,
                 "Leave out the difference's mean: for a pressure whose level nothing fixes.");
}

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
