#include "hawser/simulation/deck_language.hpp"

#include "hawser/simulation/deck_parameters.hpp"

namespace hawser {

DeckLanguage deck_language(const ModuleRegistry& registry) {
  return {RunDeck::spec().node_spec(),
          [&registry](const std::string& tag) {
            const ModuleRegistry::Entry* const entry = registry.find(tag);
            return entry == nullptr ? nullptr : &entry->spec;
          },
          registry.tags()};
}

}  // namespace hawser
