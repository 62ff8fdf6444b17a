// A deck that extends another one.
#include <algorithm>

#include "hawser/deck/spec_reader.hpp"
#include "src/deck_edit.hpp"

namespace hawser {
namespace {

constexpr const char* extends_name = "extends";
constexpr const char* remove_name = "remove";
constexpr const char* key_names[] = {"name", "quantity", "on", "region"};

class Extension {
 public:
  Extension(const DeckLanguage& language, Diagnostics& diagnostics)
      : language_(language), diagnostics_(diagnostics) {}

  void merge(DeckNode& base, const DeckNode& changes, const NodeSpec* spec) {
    for (const DeckAttribute& given : changes.attributes) {
      if (given.name == extends_name || given.name == remove_name) continue;
      const auto known = std::find_if(base.attributes.begin(), base.attributes.end(),
                                      [&](const DeckAttribute& a) { return a.name == given.name; });
      if (known == base.attributes.end())
        base.attributes.push_back(given);
      else
        *known = given;
    }
    if (!changes.attributes.empty()) base.location = changes.location;
    for (const DeckNode& child : changes.children)
      work_in(base, child, spec);
  }

 private:
  void work_in(DeckNode& parent, const DeckNode& child, const NodeSpec* parent_spec) {
    const NodeSpec* const spec = language_.find_child(parent_spec, child.tag);
    const bool removes = is_removal(child);
    DeckNode* const match = find_match(parent, child, parent_spec, spec, removes);
    if (removes) {
      if (match != nullptr)
        parent.children.erase(parent.children.begin() + (match - parent.children.data()));
    } else if (match != nullptr) {
      merge(*match, child, spec);
    } else {
      add_child(parent, child);
    }
  }

  bool is_removal(const DeckNode& node) {
    const DeckAttribute* const given = node.find_attribute(remove_name);
    if (given == nullptr) return false;
    if (trimmed(given->value) != "true")
      diagnostics_.error(given->location, "attribute 'remove' of <" + node.tag + "> is " +
                                              quoted(given->value) +
                                              ": it must be \"true\" or be left out");
    return true;
  }

  DeckNode* find_match(DeckNode& parent, const DeckNode& child, const NodeSpec* parent_spec,
                       const NodeSpec* spec, bool removes) {
    const std::vector<DeckNode*> candidates = children_of(parent, child.tag);
    const ChildSpec* const declared =
        parent_spec == nullptr ? nullptr : parent_spec->find_child(child.tag);
    if (declared != nullptr && !declared->repeats)
      return candidates.empty() ? nothing(child, spec, candidates, removes) : candidates.front();
    const DeckAttribute* const key = key_of(child, spec);
    if (key == nullptr) {
      // Of modules and reports there is mostly one of a kind, which need not be named.
      if (candidates.size() == 1 && (removes || declared == nullptr)) return candidates.front();
      if (candidates.empty() || (declared != nullptr && !removes))
        return nothing(child, spec, candidates, removes);
      diagnostics_.error(child.location, "which <" + child.tag + "> is meant? There are " +
                                             std::to_string(candidates.size()) + ": " +
                                             keys_of(candidates, spec));
      return nullptr;
    }
    for (DeckNode* const candidate : candidates) {
      const DeckAttribute* const other = candidate->find_attribute(key->name);
      if (other != nullptr && trimmed(other->value) == trimmed(key->value)) return candidate;
    }
    return nothing(child, spec, candidates, removes);
  }

  DeckNode* nothing(const DeckNode& child, const NodeSpec* spec,
                    const std::vector<DeckNode*>& candidates, bool removes) {
    if (removes)
      diagnostics_.error(child.location, "there is no such <" + child.tag +
                                             "> to remove; there are " + keys_of(candidates, spec));
    return nullptr;
  }

  const DeckLanguage& language_;
  Diagnostics& diagnostics_;
};

}  // namespace

void extend(DeckNode& base, const DeckNode& changes, const DeckLanguage& language,
            Diagnostics& diagnostics) {
  Extension(language, diagnostics).merge(base, changes, &language.root);
}

std::string NodeSpec::key() const {
  for (const char* name : key_names)
    for (const AttributeSpec& attribute : attributes)
      if (attribute.name == name) return name;
  return "";
}

const DeckAttribute* key_of(const DeckNode& node, const NodeSpec* spec) {
  if (spec != nullptr) return node.find_attribute(spec->key());
  for (const char* name : key_names)
    if (const DeckAttribute* const found = node.find_attribute(name)) return found;
  return nullptr;
}

std::string keys_of(const std::vector<DeckNode*>& nodes, const NodeSpec* spec) {
  std::vector<std::string> keys;
  for (const DeckNode* const node : nodes) {
    const DeckAttribute* const key = key_of(*node, spec);
    keys.push_back(key == nullptr ? "one without a name" : quoted(trimmed(key->value)));
  }
  return listed(keys);
}

std::vector<DeckNode*> children_of(DeckNode& node, const std::string& tag) {
  std::vector<DeckNode*> result;
  for (DeckNode& child : node.children)
    if (child.tag == tag) result.push_back(&child);
  return result;
}

DeckNode& add_child(DeckNode& parent, DeckNode child) {
  auto place = parent.children.end();
  for (auto i = parent.children.begin(); i != parent.children.end(); ++i)
    if (i->tag == child.tag) place = i + 1;
  return *parent.children.insert(place, std::move(child));
}

}  // namespace hawser
