#include "hawser/deck/deck.hpp"

#include <algorithm>
#include <fstream>

#include "hawser/base/error.hpp"

namespace hawser {

const DeckAttribute* DeckNode::find_attribute(const std::string& name) const {
  for (const DeckAttribute& attribute : attributes)
    if (attribute.name == name) return &attribute;
  return nullptr;
}

const DeckNode* DeckNode::find_child(const std::string& child_tag) const {
  for (const DeckNode& child : children)
    if (child.tag == child_tag) return &child;
  return nullptr;
}

Deck read_deck(const Communicator& communicator, const std::string& file,
               Diagnostics& diagnostics) {
  std::string text;
  communicator.on_root([&] {
    std::ifstream stream(file, std::ios::binary);
    // One byte more than allowed, so that parse_deck sees that it is too much.
    text.resize(deck_size_limit + 1);
    const bool opened = stream.is_open();
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
    if (!opened || stream.bad()) throw DeckError(file + ": the deck cannot be read");
  });
  return parse_deck(communicator.broadcast(text), file, diagnostics);
}

}  // namespace hawser
