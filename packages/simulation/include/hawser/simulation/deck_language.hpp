#pragma once
#include "hawser/deck/node_spec.hpp"
#include "hawser/simulation/registries.hpp"

namespace hawser {

/// What a deck may hold: what the program obeys itself, and the modules and reports that are known.
DeckLanguage deck_language(const Registries& registries);

}  // namespace hawser
