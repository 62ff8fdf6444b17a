#pragma once
#include "hawser/deck/read_deck.hpp"
#include "hawser/physics/module_registry.hpp"

namespace hawser {

/// What a deck may hold: everything outside of the modules, and the modules that `registry` knows.
/// It refers to the registry.
DeckLanguage deck_language(const ModuleRegistry& registry);

}  // namespace hawser
