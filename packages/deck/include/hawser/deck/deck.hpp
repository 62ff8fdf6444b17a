#pragma once
// The XML as read: a tree of plain values in which every element and attribute knows its place.
#include <memory>
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/input_files.hpp"
#include "hawser/deck/location.hpp"
#include "hawser/deck/named_value.hpp"

namespace hawser {

struct DeckAttribute {
  std::string name;
  std::string value;  ///< as written, entities resolved
  Location location;  ///< of the name
};

struct DeckNode {
  std::string tag;
  Location location;  ///< of the tag
  std::vector<DeckAttribute> attributes;
  std::vector<DeckNode> children;
  std::shared_ptr<const NamedValues> names = {};  ///< the parameters that values may use

  const DeckAttribute* find_attribute(const std::string& name) const;  ///< null when absent
  const DeckNode* find_child(const std::string& child_tag) const;  ///< the first; null if absent
};

struct Deck {
  std::string file;
  std::string text;  ///< as read; of a deck that extends or was changed, the merged one
  DeckNode root;
  /// From which it was read, and from which what it names is to be read; null for a text alone.
  std::shared_ptr<InputFiles> files = {};
};

constexpr std::size_t deck_size_limit = 16u << 20;  ///< bytes
constexpr int deck_depth_limit = 64;                ///< nested elements

/// Reads `file` on rank 0 and gives the same deck to every rank. Collective.
/// Throws DeckError (on all ranks) when the file cannot be read or is not well-formed XML; what is
/// well-formed but not allowed (duplicate attributes, text between elements, a DOCTYPE, processing
/// instructions) is added to `diagnostics`, to be reported together with the other faults.
Deck read_deck(const Communicator& communicator, const std::string& file, Diagnostics& diagnostics);

/// The same for a text at hand, which extends no other; `file` appears in the messages.
Deck parse_deck(const std::string& text, const std::string& file, Diagnostics& diagnostics);

/// XML text of an element and all that it holds, every value as given.
std::string deck_text(const DeckNode& node);

}  // namespace hawser
