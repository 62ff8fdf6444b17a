#include "hawser/simulation/run_deck.hpp"

namespace hawser {

Spec<ParameterDeck> ParameterDeck::spec() {
  using P = ParameterDeck;
  return Spec<P>("parameter", "A value with a name, for use in numbers and formulas of the deck.")
      .attribute("name", &P::name, required(), "Letters, digits and _, such as tow_speed.")
      .attribute("value", &P::value, required(),
                 "A number, a number with its unit, or a formula of earlier parameters.")
      .attribute("unit", &P::unit, absent("SI, unless the value has its own"),
                 "Of a bare number as value; also the dimension of any other.")
      .attribute("meaning", &P::meaning, absent("none"), "What it is, for the reader.");
}

Spec<PluginDeck> PluginDeck::spec() {
  return Spec<PluginDeck>("plugin", "A shared library with further physics modules or reports.")
      .attribute("name", &PluginDeck::name, required(), "Its name, without folder and ending.");
}

Spec<ModulesDeck> ModulesDeck::spec() {
  return Spec<ModulesDeck>("modules", "The physics.")
      .any_children(&ModulesDeck::modules, "physics modules");
}

Spec<RunDeck> RunDeck::spec() {
  using P = RunDeck;
  return Spec<P>("hawser", "One simulation.")
      .attribute("title", &P::title, absent("none"), "What this run is.")
      .attribute("extends", &P::extends, absent("it stands for itself"),
                 "Another deck, of which this one says what differs.")
      .children(&P::parameters)
      .child(&P::mesh, required())
      .children(&P::plugins)
      .child(&P::modules, required())
      .children(&P::fields)
      .children(&P::tracks)
      .children(&P::tables)
      .child(&P::conditions)
      .child(&P::start)
      .child(&P::time, required())
      .child(&P::solver)
      .child(&P::output)
      .children(&P::expectations)
      .child(&P::converge)
      .any_children(&P::reports, "reports");
}

}  // namespace hawser
