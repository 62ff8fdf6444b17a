// From the deck's <mesh> to a mesh.
#include <string>

#include "hawser/simulation/deck_parameters.hpp"

namespace hawser {

Spec<LineDeck> LineDeck::spec() {
  using P = LineDeck;
  return Spec<P>("line",
                 "A straight cable alone, in the plane or in space: regions cable, tow-point (its "
                 "start), tail (its end) and, with an even number of segments, middle.")
      .attribute("from", &P::from, "m", required() && any() && length(2, 3), "Where it starts.")
      .attribute("to", &P::to, "m", required() && any() && length(2, 3), "Where it ends.")
      .attribute("segments", &P::segments, required() && at_least(1), "Of equal length.")
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        if (p.from.size() != p.to.size())
          diagnostics.error(where, "'from' has " + std::to_string(p.from.size()) +
                                       " coordinates and 'to' " + std::to_string(p.to.size()));
        else if (p.from == p.to)
          diagnostics.error(where, "'from' and 'to' are the same point");
      });
}

ModuleContext MeshDeck::context() const {
  if (line) return {static_cast<int>(line->from.size()), "N"};
  if (file && file->dimension == 3) return {3, "N"};
  return {2, "N/m"};
}

std::string MeshDeck::generate(const Communicator& communicator, const std::string& path) const {
  if (tow_box) return generate_mesh(communicator, tow_box->box(), path);
  if (water_box) return generate_mesh(communicator, water_box->box(), path);
  generate_mesh(communicator, LineMesh{line->from, line->to, line->segments}, path);
  return "a line of " + std::to_string(line->segments) + " segments";
}

}  // namespace hawser
