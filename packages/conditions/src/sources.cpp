#include "src/sources.hpp"

#include <fstream>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/values/expression_source.hpp"
#include "hawser/values/table.hpp"

namespace hawser {
namespace {

std::string read_on_root(const Communicator& communicator, const std::string& path) {
  std::string text;
  communicator.on_root([&] {
    std::ifstream file(path);
    std::ostringstream all;
    all << file.rdbuf();
    if (!file) throw DeckError("cannot read the table " + path);
    text = all.str();
  });
  return communicator.broadcast(text);
}

}  // namespace

std::shared_ptr<const ValueSource> make_source(const Communicator& communicator,
                                               const ConditionDeck& deck, const Tracks& tracks,
                                               Diagnostics& diagnostics) {
  if (deck.value) return std::make_shared<ExpressionSource>(deck.value->value);
  if (deck.track) {
    if (const auto track = find_track(tracks, *deck.track, diagnostics)) return track;
  } else {
    const std::string& path = deck.table->value;
    try {
      return std::make_shared<Table>(read_on_root(communicator, path), path);
    } catch (const DeckError& error) {
      diagnostics.error(deck.table->location, error.what());
    }
  }
  return std::make_shared<ExpressionSource>(Expressions(2));
}

const Location& source_location(const ConditionDeck& deck) {
  if (deck.value) return deck.value->location;
  return deck.table ? deck.table->location : deck.track->location;
}

}  // namespace hawser
