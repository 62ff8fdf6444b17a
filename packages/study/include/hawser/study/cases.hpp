#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "hawser/study/study_deck.hpp"

namespace hawser {

/// One run of a study.
struct StudyCase {
  std::string sweep, name, title;
  std::string deck;                                         ///< path of the base deck
  std::vector<std::pair<std::string, std::string>> values;  ///< paths and what they are set to
  std::string resolved;                                     ///< the deck that all of it amounts to

  std::string folder() const { return sweep + "/" + name; }  ///< in the study's
};

/// Resolves a deck with values set: XML with every default. Throws DeckError.
using ResolveDeck = std::function<std::string(
    const std::string& deck, const std::vector<std::pair<std::string, std::string>>& values)>;

/// Every case of the study, in order, each resolved. What is wrong with one is added to
/// `diagnostics`; of the cases of a sweep the first faulty one speaks for all.
std::vector<StudyCase> expand(const StudyDeck& study, const std::string& file,
                              const ResolveDeck& resolve, Diagnostics& diagnostics);

}  // namespace hawser
