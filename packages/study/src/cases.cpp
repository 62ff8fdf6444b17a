#include "hawser/study/cases.hpp"

#include <cstdio>
#include <filesystem>
#include <set>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

std::string title_of(const Values& values) {
  std::string title;
  for (const auto& [path, value] : values)
    title += (title.empty() ? "" : ", ") + path + " = " + value;
  return title;
}

/// What the <vary> of a sweep amount to, the first changing slowest.
std::vector<Values> combinations(const SweepDeck& sweep) {
  std::vector<Values> result;
  if (sweep.varies.empty()) return result;
  if (sweep.together) {
    for (const VaryDeck& vary : sweep.varies) {
      const auto texts = vary.texts();
      result.resize(texts.size());
      for (std::size_t i = 0; i < texts.size(); ++i)
        result[i].emplace_back(vary.path.value, texts[i]);
    }
    return result;
  }
  result.emplace_back();
  for (const VaryDeck& vary : sweep.varies) {
    std::vector<Values> longer;
    for (const Values& before : result)
      for (const std::string& text : vary.texts()) {
        longer.push_back(before);
        longer.back().emplace_back(vary.path.value, text);
      }
    result = std::move(longer);
  }
  return result;
}

std::vector<StudyCase> cases_of(const SweepDeck& sweep, const std::string& deck) {
  std::vector<StudyCase> cases;
  const auto add = [&](const std::string& name, const std::string& title, Values values) {
    StudyCase one{sweep.name.value, name, title, deck, {}, {}};
    for (const SetDeck& set : sweep.sets)
      one.values.emplace_back(set.path.value, set.value.value);
    one.values.insert(one.values.end(), values.begin(), values.end());
    if (one.title.empty()) one.title = title_of(values);
    cases.push_back(std::move(one));
  };
  for (Values& values : combinations(sweep)) {
    char name[32];
    std::snprintf(name, sizeof name, "case_%02zu", cases.size() + 1);
    add(name, "", std::move(values));
  }
  for (const CaseDeck& one : sweep.cases) {
    Values values;
    for (const SetDeck& set : one.sets)
      values.emplace_back(set.path.value, set.value.value);
    add(one.name.value, one.title, std::move(values));
  }
  return cases;
}

}  // namespace

std::vector<StudyCase> expand(const StudyDeck& study, const std::string& file,
                              const ResolveDeck& resolve, Diagnostics& diagnostics) {
  std::vector<StudyCase> result;
  for (const SweepDeck& sweep : study.sweeps) {
    const std::filesystem::path name = sweep.deck.value;
    const auto folder = std::filesystem::path(file).parent_path();
    const std::string deck = (name.is_absolute() ? name : folder / name).string();
    std::set<std::string> names;
    bool told = false;
    for (StudyCase& one : cases_of(sweep, deck)) {
      if (!names.insert(one.name).second)
        diagnostics.error(sweep.location,
                          "sweep '" + sweep.name.value + "' has two cases '" + one.name + "'");
      try {
        one.resolved = resolve(deck, one.values);
      } catch (const DeckError& error) {
        if (!told)
          diagnostics.error(sweep.location, "sweep '" + sweep.name.value + "', " + one.name + " (" +
                                                one.title + "): " + error.what());
        told = true;
      }
      result.push_back(std::move(one));
    }
  }
  return result;
}

}  // namespace hawser
