#include "hawser/deck/node_spec.hpp"

#include <algorithm>

namespace hawser {

const ChildSpec* NodeSpec::find_child(const std::string& child_tag) const {
  const auto found = std::find_if(children.begin(), children.end(), [&](const ChildSpec& child) {
    return child.node.tag == child_tag;
  });
  return found == children.end() ? nullptr : &*found;
}

const NodeSpec* DeckLanguage::find_child(const NodeSpec* parent, const std::string& tag) const {
  if (parent == nullptr) return nullptr;
  if (const ChildSpec* const declared = parent->find_child(tag)) return &declared->node;
  const auto open = open_children.find(parent->tag);
  if (open == open_children.end()) return nullptr;
  for (const NodeSpec& child : open->second)
    if (child.tag == tag) return &child;
  return nullptr;
}

std::vector<ChildSpec> DeckLanguage::children(const NodeSpec& parent) const {
  std::vector<ChildSpec> result = parent.children;
  const auto open = open_children.find(parent.tag);
  if (open != open_children.end())
    for (const NodeSpec& child : open->second)
      result.push_back({child, false, true, false});
  return result;
}

}  // namespace hawser
