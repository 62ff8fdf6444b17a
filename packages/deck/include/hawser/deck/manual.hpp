#pragma once
// What a deck may hold, for readers and for editors: made of the same specs that decks are read
// with.
#include <string>
#include <vector>

#include "hawser/deck/read_deck.hpp"

namespace hawser {

/// The spec at "time", "modules/cable" or, wherever there is only one such place, "newton"; an
/// attribute's text at "time/step". The whole deck for "". Error (usage) with the nearest name.
std::string describe(const DeckLanguage& language, const std::string& path);

/// doc/deck_reference.md: a section per element, with a table of its attributes.
std::string deck_reference(const DeckLanguage& language);

/// An XML Schema (XSD 1.0) of names, nesting, types and words, with every meaning as documentation.
/// What is required is not in it: a deck that extends another one may leave anything out.
std::string schema(const DeckLanguage& language);

}  // namespace hawser
