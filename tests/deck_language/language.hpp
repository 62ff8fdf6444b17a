#pragma once
// What the shipped program understands, and every element of it.
#include <string>
#include <vector>

#include "ale_fluid.hpp"
#include "cable.hpp"
#include "hawser/simulation/deck_language.hpp"
#include "hawser/simulation/deck_parameters.hpp"
#include "mesh_motion.hpp"

namespace hawser {

inline const ModuleRegistry& modules() {
  static const ModuleRegistry registry = [] {
    ModuleRegistry result;
    register_ale_fluid(result);
    register_cable(result);
    register_mesh_motion(result);
    return result;
  }();
  return registry;
}

inline const DeckLanguage& language() {
  static const DeckLanguage known = deck_language(modules());
  return known;
}

/// Calls visit(spec, path) for an element and all that may stand in it.
template <class Visit>
void for_each_element(const NodeSpec& spec, const std::string& path, const Visit& visit) {
  visit(spec, path);
  for (const ChildSpec& child : spec.children)
    for_each_element(child.node, path + "/" + child.node.tag, visit);
  if (spec.open_children.empty()) return;
  for (const std::string& tag : language().open_tags)
    for_each_element(*language().open_children(tag), path + "/" + tag, visit);
}

}  // namespace hawser
