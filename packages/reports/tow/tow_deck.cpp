#include "tow_deck.hpp"

#include <algorithm>
#include <functional>

#include "hawser/base/error.hpp"
#include "hawser/navigation/chart.hpp"
#include "hawser/navigation/clock.hpp"
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
      .choice(
          "course", &P::course, {{"as-said", P::Course::as_said}, {"motion", P::Course::motion}},
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

Spec<NavigationFileDeck> NavigationFileDeck::spec() {
  using P = NavigationFileDeck;
  return Spec<P>(
             "navigation-file",
             "At the end of the run, all shots of receivers.csv as UKOOA P1/90, which navigation "
             "software reads: x is east and y is north on a chart.")
      .attribute("name", &P::file, required(), "Of the file, in the folder of the results.")
      .attribute("crs", &P::crs, required(),
                 "The chart, a projected coordinate reference system in metres as PROJ knows it: "
                 "EPSG:32631 is UTM zone 31 north on WGS 84.")
      .attribute("origin", &P::origin, "m", required() && any() && length(2),
                 "Easting and northing of x = y = 0.")
      .attribute("epoch", &P::epoch, required(), "UTC at t = 0, such as 2026-05-03T10:00:00Z.")
      .attribute("line", &P::line, "Name of the line, 12 characters at most.")
      .attribute("first-shot", &P::first_shot, at_least(0), "Number of the first shot.")
      .attribute("streamer", &P::streamer, between(0, 9), "Number of the streamer.")
      .attribute("depth", &P::depth, "m", non_negative(),
                 "Of the cable, where the deck is in the plane; in space it is -z.")
      .check([](const P& p, const Location&, Diagnostics& diagnostics) {
        double seconds = 0;
        if (const std::string wrong = read_clock(p.epoch, seconds); !wrong.empty())
          diagnostics.error(p.epoch.location, "epoch=\"" + *p.epoch + "\": " + wrong);
        if (p.line.size() > 12)
          diagnostics.error(p.file.location,
                            "the line's name has more than the 12 characters of P1/90");
        if (p.file->find('/') != std::string::npos)
          diagnostics.error(p.file.location,
                            "the file lies in the folder of the results; give a name");
        try {
          Chart(p.crs).geographic({p.origin[0], p.origin[1]});
        } catch (const DeckError& error) {
          diagnostics.error(p.crs.location, error.what());
        }
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
                 "Steps between further entries; 0 for none. With none of the three, at the end.")
      .attribute(
          "shot-distance", &P::shot_distance, "m", non_negative(),
          "Way of the tow point between shots, the first of which is where it begins; between "
          "two steps the positions are interpolated. 0 for none.")
      .child(&P::navigation)
      .check([](const P& p, const Location&, Diagnostics& diagnostics) {
        if (p.shot_distance > 0 && (p.every > 0 || !p.times->empty()))
          diagnostics.error(p.shot_distance.location,
                            "shots are either by distance, or by times or steps");
        if (!std::is_sorted(p.at->begin(), p.at->end(), std::less_equal<>()) && p.at->size() > 1)
          diagnostics.error(p.at.location, "places of receivers ascend along the cable");
      });
}

}  // namespace hawser
