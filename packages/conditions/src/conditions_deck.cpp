#include "hawser/conditions/conditions_deck.hpp"

namespace hawser {
namespace {

Spec<ConditionDeck> condition_spec(const std::string& tag, const std::string& meaning) {
  using P = ConditionDeck;
  Spec<P> spec = Spec<P>(tag, meaning)
                     .attribute("name", &P::name, absent("it has none"),
                                "By which another deck or --set can change it.")
                     .attribute("field", &P::field, required(), "Field by name, such as velocity.")
                     .attribute("on", &P::on, required(), "Regions, by name.")
                     .attribute("component", &P::component, one_of({"all", "x", "y", "z"}),
                                "Which component the value is for.")
                     .location(&P::location);
  return P::declare_sources(std::move(spec))
      .check([tag](const P& p, const Location& where, Diagnostics& diagnostics) {
        auto names = P::source_attributes();
        const std::string last = names.back();
        names.pop_back();
        if (p.sources_given() != 1)
          diagnostics.error(where,
                            "<" + tag + "> needs exactly one of " + listed(names) + " and " + last);
      });
}

}  // namespace

Spec<ConditionDeck> ConditionDeck::initial_spec() {
  return condition_spec("initial",
                        "A field's values at the start; later ones replace earlier ones.");
}
Spec<ConditionDeck> ConditionDeck::prescribe_spec() {
  using P = ConditionDeck;
  return condition_spec("prescribe",
                        "A field's values on a region, at all times or within a window.")
      .attribute("from", &P::from, "s", any() && absent("from the start"),
                 "Holds for steps that end after this time.")
      .attribute("until", &P::until, "s", any() && absent("to the end"),
                 "Holds for steps that end at this time or before.")
      .attribute("replaces", &P::replaces,
                 "It is meant to hold at nodes where an earlier one says something else; later "
                 "ones always do, and without this a note says where.")
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        if (p.from && p.until && *p.from >= *p.until)
          diagnostics.error(where, "it never holds: 'from' is not before 'until'");
      });
}

Spec<ConditionsDeck> ConditionsDeck::spec() {
  using P = ConditionsDeck;
  return Spec<P>("conditions", "Initial and prescribed values.")
      .children(&P::initial, ConditionDeck::initial_spec())
      .children(&P::prescribe, ConditionDeck::prescribe_spec());
}

}  // namespace hawser
