#pragma once
// A deck read and checked, before any mesh: its text, its parameters, the modules they
// make and the reports they plan.
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/simulation/deck_parameters.hpp"
#include "hawser/simulation/registries.hpp"
#include "hawser/simulation/simulation.hpp"

namespace hawser {

struct RunCase {
  Deck text;
  RunDeck deck;
  std::vector<PhysicsModule> modules;
  std::vector<PlannedReport> reports;
};

/// Loads the deck's plug-ins into `registries`. Collective; DeckError with every fault, those in
/// `diagnostics` included, or PluginError, on all ranks.
RunCase read_case(const Communicator& communicator, Deck text, const RunOptions& options,
                  Registries& registries, Diagnostics& diagnostics);

/// XML with every default.
std::string resolved(const Deck& deck, const Registries& registries);

/// Path of the deck's mesh file; one that must be made is made at `place`, and `made` is what the
/// mesher says about it. Collective; MeshError on all ranks.
struct ProvidedMesh {
  std::string file;
  std::string made;  ///< empty for a mesh that was there
};
ProvidedMesh provide_mesh(const Communicator& communicator, const RunCase& run,
                          const std::string& place);

}  // namespace hawser
