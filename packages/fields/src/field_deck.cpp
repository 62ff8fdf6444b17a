#include "hawser/fields/field_deck.hpp"

namespace hawser {

Spec<FieldDeck> FieldDeck::spec() {
  using P = FieldDeck;
  return Spec<P>("field",
                 "The shape functions and the numbering of a field, when the modules' wishes are "
                 "not meant.")
      .attribute("name", &P::name, required(), "Field that some module solves for.")
      .choice("basis", &P::basis, absent("as the modules wish, else P1"),
              {{"P1", Basis::p1}, {"P2", Basis::p2}},
              "Degree of its shape functions: linear, or quadratic with nodes on edges, too.")
      .choice("numbering", &P::numbering, absent("as the modules wish, else continuous"),
              {{"continuous", Numbering::continuous}, {"sides", Numbering::sides}},
              "\"sides\" has a value on either side of the mesh's slits.")
      .source("doc/numerics.md");
}

}  // namespace hawser
