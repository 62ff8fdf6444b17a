#pragma once
// From a file to a deck: what it extends and what the command line changes are worked in.
//
// <hawser extends="base.xml"> takes over the other deck, whose path is relative to this one. Here
// stands only what differs:
//   - an element is matched by its tag, where it stands once, and else by its key as well: the
//     attribute NodeSpec::key(), such as `name`; without a key it is a new one;
//   - attributes given replace those of the base, elements that match none are added;
//   - remove="true" takes the element away.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/deck/deck.hpp"
#include "hawser/deck/node_spec.hpp"

namespace hawser {

/// One value of a deck that is replaced: "time/step", "conditions/prescribe[inflow]/value",
/// "expect[end_error_m]/within", "probe[2]/on", or the name of a parameter. With no value the
/// attribute is taken away, or the element at "expect[end_error_m]".
struct DeckChange {
  std::string path, value;
  std::string text() const { return path + "=" + value; }
};

/// From "path=value"; an Error (usage) when there is no '='.
DeckChange read_change(const std::string& text);

/// The text of a file; none when it cannot be read.
using DeckFiles = std::function<std::optional<std::string>(const std::string& file)>;

/// Reads `file` and what it extends on rank 0 and gives the same deck to every rank. Collective.
/// Errors as the simpler read_deck(); in a merged deck every value keeps the place where it was
/// written, and Deck::text is the merged deck, which needs no other file.
Deck read_deck(const Communicator& communicator, const std::string& file,
               const std::vector<DeckChange>& changes, const DeckLanguage& language,
               Diagnostics& diagnostics);

/// The same with the files from there; the deck keeps them.
Deck read_deck(const std::shared_ptr<InputFiles>& files, const std::string& file,
               const std::vector<DeckChange>& changes, const DeckLanguage& language,
               Diagnostics& diagnostics);

/// The same on one rank, with the files' texts from anywhere.
Deck read_deck(const DeckFiles& files, const std::string& file,
               const std::vector<DeckChange>& changes, const DeckLanguage& language,
               Diagnostics& diagnostics);

/// `name`, or, when it is relative, `name` in the folder of the deck in which it was written. What
/// the command line names is relative to the folder of `deck`.
std::string path_beside(const Deck& deck, const Located<std::string>& name);

}  // namespace hawser
