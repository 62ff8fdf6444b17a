// What a deck says of its results: <output>, <tow>, <receivers>, <force>, <expect>.
#include <cctype>

#include "hawser/simulation/deck_parameters.hpp"

namespace hawser {

Spec<TowDeck> TowDeck::spec() {
  using P = TowDeck;
  return Spec<P>("tow",
                 "Reports the positioning errors of a towed cable and the force at its tow point.")
      .attribute("cable", &P::cable, required(), "Line region of the cable.")
      .attribute("tow-point", &P::tow_point, required(), "Point region where it is towed.")
      .attribute("angle", &P::angle, "deg", between(-180, 180),
                 "Of the tow axis from upstream (+y) toward +x.")
      .attribute("speed", &P::speed, "m/s", non_negative(),
                 "Of the tow, for the exact straight-cable values.")
      .attribute("current", &P::current, "m/s", non_negative(), "Of the water along -y, likewise.")
      .attribute("track", &P::track, absent("straight on"),
                 "The <track> that is towed along: the tow axis is its present course, instead of "
                 "angle and speed.")
      .child(&P::receivers);
}

Spec<ReceiversDeck> ReceiversDeck::spec() {
  using P = ReceiversDeck;
  return Spec<P>("receivers", "Writes receivers.csv: where each receiver of the cable is.")
      .attribute("spacing", &P::spacing, "m", positive(), "Between receivers, unstretched.")
      .attribute("first", &P::first, "m", non_negative(),
                 "From the tow point to the first receiver, unstretched.")
      .attribute("times", &P::times, "s", non_negative() && absent("at none"),
                 "When; between two steps the positions are interpolated.")
      .attribute("every", &P::every, at_least(0),
                 "Steps between further entries; 0 for none. With neither, at the end.");
}

namespace {

/// It becomes part of a table's columns and of the names in summary.json.
template <class P>
void check_column_name(const P& p, const Location& where, Diagnostics& diagnostics) {
  const bool fits = std::all_of(p.name.begin(), p.name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
  if (!fits)
    diagnostics.error(where, "the name '" + p.name +
                                 "' becomes a column of history.csv; letters, digits, _ and - are "
                                 "allowed");
}

}  // namespace

Spec<ForceDeck> ForceDeck::spec() {
  using P = ForceDeck;
  return Spec<P>("force",
                 "Reports the force on a region: of one module, or the support's reaction.")
      .attribute("name", &P::name, required(), "Start of the quantities' names.")
      .attribute("on", &P::on, required(), "Region whose velocity rows are summed.")
      .attribute("module", &P::module,
                 "Module whose load on the region is reported; all for the reaction.")
      .attribute("axis", &P::axis, "1", any() && length(2, 3) && absent("+x"),
                 "Direction of the component called along; across is 90 degrees left, in "
                 "space the magnitude of the rest.")
      .check(check_column_name<P>);
}

Spec<ProbeDeck> ProbeDeck::spec() {
  using P = ProbeDeck;
  return Spec<P>("probe", "Writes a field at one point over time.")
      .attribute("name", &P::name, required(), "Column name and start of the quantities' names.")
      .attribute("on", &P::on, required(), "Point region.")
      .attribute("field", &P::field, required(), "Field by name.")
      .check(check_column_name<P>);
}

Spec<OutputDeck> OutputDeck::spec() {
  using P = OutputDeck;
  return Spec<P>("output", "What is written, and how often.")
      .attribute("fields-every", &P::fields_every, at_least(0),
                 "Steps between outputs of the fields; 0 for the end only.")
      .attribute("history-every", &P::history_every, at_least(1),
                 "Steps between rows of the histories.")
      .attribute("checkpoint-every", &P::checkpoint_every, at_least(0),
                 "Steps between checkpoints; 0 for none.")
      .children(&P::probes);
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
