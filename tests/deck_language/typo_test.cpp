// Whoever mistypes a name by one letter is told the right one.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "language.hpp"

namespace hawser {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Every attribute of the shipped decks, with the names that are allowed beside it.
std::map<std::string, std::set<std::vector<std::string>>> names_in_shipped_decks() {
  std::map<std::string, std::set<std::vector<std::string>>> result;
  const auto collect = [&](const DeckNode& node, const NodeSpec* spec, const auto& again) -> void {
    if (spec == nullptr) return;
    std::vector<std::string> allowed;
    for (const AttributeSpec& attribute : spec->attributes)
      allowed.push_back(attribute.name);
    for (const DeckAttribute& attribute : node.attributes)
      result[attribute.name].insert(allowed);
    for (const DeckNode& child : node.children) {
      again(child, language().find_child(spec, child.tag), again);
    }
  };
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(HAWSER_SOURCE_DIR "/inputs")) {
    if (entry.path().extension() != ".xml") continue;
    Diagnostics none;
    const Deck deck = parse_deck(text_of(entry.path()), entry.path().string(), none);
    if (deck.root.tag == language().root.tag) collect(deck.root, &language().root, collect);
  }
  return result;
}

/// One letter left out, replaced, put in, or exchanged with its neighbour, at every place.
std::set<std::string> typos(const std::string& name) {
  const std::string letters = "abcdefghijklmnopqrstuvwxyz-";
  std::set<std::string> result;
  for (std::size_t i = 0; i <= name.size(); ++i) {
    for (const char c : letters) {
      result.insert(name.substr(0, i) + c + name.substr(i));
      if (i < name.size()) result.insert(name.substr(0, i) + c + name.substr(i + 1));
    }
    if (i < name.size()) result.insert(name.substr(0, i) + name.substr(i + 1));
    if (i + 1 < name.size()) {
      std::string exchanged = name;
      std::swap(exchanged[i], exchanged[i + 1]);
      result.insert(exchanged);
    }
  }
  result.erase(name);
  result.erase("");
  return result;
}

/// All names within one letter of `typo`.
std::set<std::string> one_letter_off(const std::string& typo,
                                     const std::vector<std::string>& names) {
  const std::set<std::string> around = typos(typo);
  std::set<std::string> result;
  for (const std::string& name : names)
    if (around.count(name) > 0) result.insert(name);
  return result;
}

TEST(Typos, OfEveryParameterInTheShippedDecksFindTheRightName) {
  long tried = 0;
  std::string other_names;
  for (const auto& [name, surroundings] : names_in_shipped_decks())
    for (const std::vector<std::string>& allowed : surroundings) {
      if (name == "remove") continue;  // of a deck that extends another one; no parameter
      ASSERT_EQ(std::count(allowed.begin(), allowed.end(), name), 1) << name;
      for (const std::string& typo : typos(name)) {
        ++tried;
        if (std::count(allowed.begin(), allowed.end(), typo) > 0) {
          other_names += "  " + typo + " for " + name + "\n";  // valid, and another one
          continue;
        }
        const std::string suggested = nearest_name(typo, allowed);
        if (suggested == name) continue;
        // Just as near to another name: one of the two must be suggested.
        EXPECT_EQ(one_letter_off(typo, allowed).count(suggested), 1u)
            << typo << " for " << name << " suggests '" << suggested << "'";
      }
    }
  std::printf("%ld typing errors; those that are another parameter of the same element:\n%s", tried,
              other_names.empty() ? "  none\n" : other_names.c_str());
  EXPECT_GT(tried, 10000);
}

}  // namespace
}  // namespace hawser
