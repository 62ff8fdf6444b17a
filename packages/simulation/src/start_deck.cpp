#include "hawser/simulation/start_deck.hpp"

namespace hawser {

Spec<ContinuationDeck> ContinuationDeck::spec() {
  using P = ContinuationDeck;
  return Spec<P>("continuation",
                 "Finds the steady state in a series: at another value of a parameter first, then "
                 "from state to state, extrapolated, to the value that the deck gives.")
      .attribute("parameter", &P::parameter, required(), "A <parameter> of the deck, by name.")
      .attribute("from", &P::from, "as the parameter", required() && any(),
                 "Its value at first, where the steady state is easy to find.")
      .attribute("steps", &P::steps, at_least(1),
                 "Into which the way is divided; a step that fails is halved, one that is easy is "
                 "followed by a longer one.")
      .choice("spacing", &P::geometric, {{"linear", false}, {"geometric", true}},
              "Steps of equal differences, or of equal ratios.");
}

void ContinuationDeck::check(const NamedValues* parameters, Diagnostics& diagnostics) const {
  const NamedValue* const own = find_named(parameters, parameter.value);
  if (own == nullptr) {
    std::vector<std::string> names;
    for (std::size_t i = 0; parameters != nullptr && i < parameters->size(); ++i)
      names.push_back((*parameters)[i].name);
    return diagnostics.error(parameter.location, "the deck has no parameter '" + parameter.value +
                                                     "'; it has " + listed(names));
  }
  if (!from.value.is_constant())
    return diagnostics.error(from.location, "a constant is needed, no formula of place and time");
  const double first = from.value({});
  if (from.value.unit() && own->unit && !same_dimension(*from.value.unit(), *own->unit))
    diagnostics.error(from.location, "the value is in " + from.value.unit()->text +
                                         ", and the parameter in " + own->unit->text);
  else if (first == own->value)
    diagnostics.error(from.location, "this is the value of '" + parameter.value +
                                         "' in the deck: there is no way to go");
  else if (geometric && first * own->value <= 0)
    diagnostics.error(from.location, "no ratio leads from " + write_value(first) + " to " +
                                         write_value(own->value) + "; use spacing=\"linear\"");
}

Spec<EquilibriumDeck> EquilibriumDeck::spec() {
  using P = EquilibriumDeck;
  return Spec<P>("equilibrium",
                 "Solves for the steady state under the conditions and loads at the time of the "
                 "start; the run begins there, at rest or in uniform motion.")
      .source("doc/decks.md, \"How a run starts\"")
      .attribute("tolerance", &P::tolerance, "1",
                 between(1e-15, 1e-1) && absent("that of <newton>"),
                 "Of Newton's method, as in <newton>.")
      .attribute("max-iterations", &P::max_iterations, at_least(1),
                 "Of Newton's method in one solve.")
      .attribute("relaxation-step", &P::relaxation_step, "s",
                 positive() && absent("the step of <time>"),
                 "Length of the first step of the relaxation that takes over where Newton's "
                 "method finds no steady state; later ones are longer or shorter by its effort.")
      .attribute("velocity", &P::velocity, "m/s", any() && length(2, 3) && absent("at rest"),
                 "On a mesh of lines alone: all moves along with this velocity, as a tow that has "
                 "gone straight on for long; what is prescribed must move so at the start, too.")
      .child(&P::continuation);
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
