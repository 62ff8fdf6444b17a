#pragma once
// The fields of a run, gathered from what the modules declare and wish and what the deck decides.
#include <vector>

#include "hawser/fields/dof_map.hpp"
#include "hawser/fields/field_deck.hpp"
#include "hawser/physics/kernel.hpp"

namespace hawser {

struct FieldTable {
  std::vector<FieldDescription> fields;
  std::vector<RateRule> rate_rules;  ///< per field
};

/// A field lives on the union of the regions where some module adds to, governs or drives it.
/// Structures' displacements come first and scalars last, which suits incomplete factorisations.
/// Its basis and numbering are the deck's, else what those modules wish that add to, govern or
/// drive it, else P1 and continuous.
///
/// PluginError when two modules describe a field of one name differently; DeckError when their
/// wishes contradict each other and the deck does not decide, when a module cannot work with what
/// was decided, or when somebody names a field that no module solves for.
FieldTable gather_fields(const std::vector<PhysicsModule>& modules,
                         const std::vector<FieldDeck>& decisions = {});

}  // namespace hawser
