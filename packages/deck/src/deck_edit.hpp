#pragma once
// Steps between the XML as parsed and the deck as read.
#include <string>

#include "hawser/deck/read_deck.hpp"

namespace hawser {

/// The XML of one file, as it is.
DeckNode parse_xml(const std::string& text, const std::string& file, Diagnostics& diagnostics);

/// Works the root element of a deck into that of the deck which it extends.
void extend(DeckNode& base, const DeckNode& changes, const DeckLanguage& language,
            Diagnostics& diagnostics);

/// Replaces one value.
void apply(const DeckChange& change, DeckNode& root, const DeckLanguage& language,
           Diagnostics& diagnostics);

/// Evaluates the <parameter> children of the root and hands their values to every element. One that
/// nothing uses and whose name nearly is that of one in use is a fault.
void define_parameters(DeckNode& root, Diagnostics& diagnostics);

/// The attribute that tells an element from others of its tag: the one that the spec names, or,
/// without a spec, the first of name, quantity, on, region that it has. Null when it has none.
const DeckAttribute* key_of(const DeckNode& node, const NodeSpec* spec);

/// "'a', 'b'": the keys of the elements.
std::string keys_of(const std::vector<DeckNode*>& nodes, const NodeSpec* spec);

std::vector<DeckNode*> children_of(DeckNode& node, const std::string& tag);

/// Behind the last one of its tag, or at the end.
DeckNode& add_child(DeckNode& parent, DeckNode child);

}  // namespace hawser
