#pragma once
// A Spec without its C++ types: what `hawser describe`, the schema, the reference manual and the
// resolved deck are made of.
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "hawser/deck/deck.hpp"
#include "hawser/deck/value.hpp"

namespace hawser {

struct AttributeSpec {
  std::string name;
  std::string type;          ///< "number", "whole number", "text", …
  std::string unit;          ///< "kg/m^3"; "1" for a plain number; empty for texts
  std::string default_text;  ///< as it would be written; empty: required, or absent unless given
  std::string range;    ///< "> 0"; "any" when anything goes; empty where there is nothing to say
  std::string meaning;  ///< one sentence
  std::vector<std::string> choices;  ///< when only certain words are allowed
  bool is_required = false;
  std::string absent = {};  ///< what it means to leave it out, when there is no default
  /// What the text amounts to, as plain numbers in `unit`; empty for texts. A faulty text is
  /// returned as it is.
  std::function<std::string(const Reading&)> resolve = {};
};

struct ChildSpec;

struct NodeSpec {
  std::string tag;
  std::string meaning;
  std::vector<AttributeSpec> attributes;
  std::vector<ChildSpec> children;
  std::string source = {};    ///< where its formulas come from: a page of the documentation
  std::string open_children;  ///< not empty: what kind of children the language knows beside these

  const ChildSpec* find_child(const std::string& child_tag) const;  ///< declared ones; or null

  /// The attribute that tells repeated elements apart, where decks are extended or changed: the
  /// first of name, quantity, on, region that there is; or "".
  std::string key() const;
};

struct ChildSpec {
  NodeSpec node;
  bool is_required = false;
  bool repeats = false;
  bool has_defaults = false;  ///< when absent, it counts as written with all its defaults
};

/// What a deck may hold: the specs of its elements.
struct DeckLanguage {
  NodeSpec root;
  /// Children that are known at run time only (modules, reports), by the tag of their parent.
  std::map<std::string, std::vector<NodeSpec>> open_children = {};

  /// Declared and open children alike; null when there is none of that tag, or no parent.
  const NodeSpec* find_child(const NodeSpec* parent, const std::string& tag) const;
  std::vector<ChildSpec> children(const NodeSpec& parent) const;
};

/// For people: every attribute and child with type, unit, default, range and meaning. manual.hpp
/// has more of the kind.
std::string describe(const NodeSpec& spec);

/// The deck that `node` amounts to, as XML: every value as a plain number in its attribute's unit
/// (with a comment that says how it was given), and every default that was used.
std::string resolved_deck(const DeckNode& node, const DeckLanguage& language);

/// Reports `child` when its tag is not among `allowed` (with the nearest name) and returns false
/// then.
bool is_known_child(const DeckNode& child, const std::string& parent_tag,
                    const std::vector<std::string>& allowed, Diagnostics& diagnostics);

}  // namespace hawser
