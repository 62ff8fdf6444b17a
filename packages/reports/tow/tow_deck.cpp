#include "tow_deck.hpp"

#include <algorithm>
#include <functional>

#include "hawser/report/report_name.hpp"

namespace hawser {

Spec<TowDeck> TowDeck::spec() {
  using P = TowDeck;
  return Spec<P>("tow",
                 "Reports the positioning errors of a towed cable and the force at its tow point.")
      .attribute("name", &P::name, absent("none"),
                 "Start of the names of its quantities and files, NAME_end_error_m and "
                 "NAME_cable.csv; tells several apart.")
      .attribute("cable", &P::cable, required(), "Line region of the cable.")
      .attribute("tow-point", &P::tow_point, required(), "Point region where it is towed.")
      .attribute("angle", &P::angle, "deg", between(-180, 360),
                 "Of the tow axis from upstream (+y) toward +x: a compass bearing, where +y is "
                 "north.")
      .attribute("speed", &P::speed, "m/s",
                 non_negative() && absent("no exact values, unless on a track"),
                 "Of the tow, for the exact straight-cable values.")
      .attribute("current", &P::current, "m/s", non_negative() && absent("no exact values"),
                 "Of the water along -y, likewise.")
      .attribute("track", &P::track, absent("straight on"),
                 "The <track> that is towed along: the tow axis is its present course, instead of "
                 "angle and speed.")
      .choice("course", &P::course,
              {{"as-said", P::Course::as_said}, {"motion", P::Course::motion}},
              "Where the tow axis points: as angle or track say, or where the tow point goes at the "
              "time, whatever moves it: a table, a formula, a track.")
      .child(&P::receivers)
      .check(check_report_name<P>)
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        if (p.course == P::Course::motion && (p.track || p.speed || p.angle.location.line > 0))
          diagnostics.error(where,
                            "with course=\"motion\" the motion says what angle, speed and track "
                            "would; take them away");
      });
}

Spec<ReceiversDeck> ReceiversDeck::spec() {
  using P = ReceiversDeck;
  return Spec<P>("receivers", "Writes receivers.csv: where each receiver of the cable is.")
      .attribute("spacing", &P::spacing, "m", positive(), "Between receivers, unstretched.")
      .attribute("first", &P::first, "m", non_negative(),
                 "From the tow point to the first receiver, unstretched.")
      .attribute("at", &P::at, "m", non_negative() && absent("by first and spacing"),
                 "Places of the receivers from the tow point, unstretched, in ascending order.")
      .attribute("times", &P::times, "s", non_negative() && absent("at none"),
                 "When; between two steps the positions are interpolated.")
      .attribute("every", &P::every, at_least(0),
                 "Steps between further entries; 0 for none. With neither, at the end.")
      .check([](const P& p, const Location&, Diagnostics& diagnostics) {
        if (!std::is_sorted(p.at->begin(), p.at->end(), std::less_equal<>()) && p.at->size() > 1)
          diagnostics.error(p.at.location, "places of receivers ascend along the cable");
      });
}

}  // namespace hawser
