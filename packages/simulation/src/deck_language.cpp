#include "hawser/simulation/deck_language.hpp"

#include "hawser/simulation/run_deck.hpp"

namespace hawser {

DeckLanguage deck_language(const Registries& registries) {
  DeckLanguage language{RunDeck::spec().node_spec()};
  for (const std::string& tag : registries.modules.tags())
    language.open_children["modules"].push_back(registries.modules.find(tag)->spec);
  for (const char* parent : {"hawser", "output"})
    language.open_children[parent] = registries.reports.specs(parent);
  return language;
}

}  // namespace hawser
