#pragma once
// What the shipped program understands, and every element of it.
#include <string>
#include <vector>

#include "hawser/simulation/deck_language.hpp"
#include "hawser/simulation/run_deck.hpp"

namespace hawser {

inline const Registries& known() {
  static const Registries registries = built_in();
  return registries;
}

inline const DeckLanguage& language() {
  static const DeckLanguage all = deck_language(known());
  return all;
}

/// Calls visit(spec, path) for an element and all that may stand in it.
template <class Visit>
void for_each_element(const NodeSpec& spec, const std::string& path, const Visit& visit) {
  visit(spec, path);
  for (const ChildSpec& child : language().children(spec))
    for_each_element(child.node, path + "/" + child.node.tag, visit);
}

}  // namespace hawser
