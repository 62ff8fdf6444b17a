#include "src/refinement.hpp"

#include <cmath>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

DeckChange finer_mesh(const MeshDeck& mesh, int level) {
  if (mesh.tow_box)
    return {"mesh/tow-box/refinements", write_value(mesh.tow_box->refinements + level)};
  if (mesh.water_box)
    return {"mesh/water-box/refinements", write_value(mesh.water_box->refinements + level)};
  if (mesh.geo) return {"mesh/geo/refinements", write_value(mesh.geo->refinements + level)};
  if (mesh.lines) return {"mesh/lines/refinements", write_value(mesh.lines->refinements + level)};
  if (mesh.line) return {"mesh/line/segments", write_value(mesh.line->segments << level)};
  throw DeckError(mesh.file->name.location.text() +
                  ": a mesh from a file cannot be refined; refine in time, or let the deck "
                  "generate its mesh");
}

}  // namespace

std::vector<DeckChange> refinement(const RunDeck& deck, Refinement what, int level) {
  std::vector<DeckChange> changes;
  if (what != Refinement::time) changes.push_back(finer_mesh(deck.mesh, level));
  if (what == Refinement::space) return changes;
  if (deck.time.steady())
    throw DeckError(deck.time.location.text() + ": a steady solve has no step to refine");
  changes.push_back({"time/step", write_value(std::ldexp(deck.time.step, -level))});
  changes.push_back({"time/least-step", write_value(std::ldexp(deck.time.least, -level))});
  return changes;
}

}  // namespace hawser
