#include "hawser/study/study_deck.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace hawser {
namespace {

/// Of blank-separated numbers or words; with a ';' anything that stands between two of them.
std::vector<std::string> listed_values(const std::string& text) {
  if (text.find(';') == std::string::npos) return split_at_blanks(text);
  std::vector<std::string> values = split_at(text, ';');
  values.erase(std::remove(values.begin(), values.end(), ""), values.end());
  return values;
}

bool is_folder_name(const std::string& name) {
  return name.find_first_not_of(
             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
         std::string::npos;
}

void check_name(const Located<std::string>& name, Diagnostics& diagnostics) {
  if (!is_folder_name(name.value))
    diagnostics.error(name.location, quoted(name.value) +
                                         " becomes the name of a folder; allowed: letters, digits, "
                                         "_ and -");
}

template <class Named>
void check_names(const std::vector<Named>& items, Diagnostics& diagnostics) {
  std::set<std::string> seen;
  for (const Named& item : items) {
    check_name(item.name, diagnostics);
    if (!seen.insert(item.name.value).second)
      diagnostics.error(item.name.location, "the name " + quoted(item.name.value) +
                                                " is given twice; each becomes a folder");
  }
}

}  // namespace

Spec<SetDeck> SetDeck::spec() {
  return Spec<SetDeck>("set", "A value that differs from the base deck.")
      .attribute("path", &SetDeck::path, required(),
                 "A parameter of the base deck, or a path as in --set: time/step.")
      .attribute("value", &SetDeck::value, required(), "The value, as a deck would give it.");
}

Spec<VaryDeck> VaryDeck::spec() {
  using P = VaryDeck;
  return Spec<P>("vary", "A value that goes through a list, or through a range.")
      .attribute("path", &P::path, required(),
                 "A parameter of the base deck, or a path as in --set: time/step.")
      .attribute("values", &P::values, "A list; values that hold blanks are set apart by ';'.")
      .attribute("from", &P::from, "as the value", "First value of a range.")
      .attribute("to", &P::to, "as the value", "Last value of a range.")
      .attribute("count", &P::count, at_least(2), "Number of values in the range.")
      .choice("spacing", &P::logarithmic, {{"linear", false}, {"logarithmic", true}},
              "Equal differences, or equal ratios.")
      .location(&P::location)
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        const bool range = p.from || p.to || p.count;
        if (p.values.has_value() == range || (range && !(p.from && p.to && p.count)))
          diagnostics.error(where, "<vary> needs either values, or from, to and count");
        else if (p.values && listed_values(p.values->value).empty())
          diagnostics.error(p.values->location, "the list of values is empty");
        else if (range && *p.from == *p.to)
          diagnostics.error(where,
                            "the range is empty: from and to are both " + write_value(*p.from));
        else if (range && p.logarithmic && !(*p.from > 0 && *p.to > 0))
          diagnostics.error(where, "a logarithmic range needs positive ends");
      });
}

std::vector<std::string> VaryDeck::texts() const {
  if (values) return listed_values(values->value);
  std::vector<std::string> result;
  for (int i = 0; i < *count; ++i) {
    const double share = static_cast<double>(i) / (*count - 1);
    double value =
        logarithmic ? *from * std::pow(*to / *from, share) : *from + share * (*to - *from);
    if (i == *count - 1) value = *to;
    std::ostringstream text;  // what a person would write; the 17th digit helps nobody
    text.precision(12);
    text << value;
    result.push_back(text.str());
  }
  return result;
}

Spec<CaseDeck> CaseDeck::spec() {
  using P = CaseDeck;
  return Spec<P>("case", "One case of its own, beside those of <vary>.")
      .attribute("name", &P::name, required(), "Of its folder.")
      .attribute("title", &P::title, "What it is.")
      .children(&P::sets);
}

Spec<SweepDeck> SweepDeck::spec() {
  using P = SweepDeck;
  return Spec<P>("sweep", "Cases made from one deck.")
      .attribute("name", &P::name, required(), "Of its folder.")
      .attribute("deck", &P::deck, required(), "Base deck; a relative path starts at the study.")
      .attribute("meaning", &P::meaning, "What it shows; a sentence in the report.")
      .choice("combine", &P::together, {{"grid", false}, {"together", true}},
              "Every combination of the values, the first <vary> changing slowest; or all first "
              "values, all second values, ...")
      .children(&P::sets)
      .children(&P::varies)
      .children(&P::cases)
      .location(&P::location)
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        check_names(p.cases, diagnostics);
        if (p.varies.empty() && p.cases.empty())
          diagnostics.error(where, "<sweep> holds no case: it needs a <vary> or a <case>");
        for (const VaryDeck& vary : p.varies)
          if (p.together && vary.texts().size() != p.varies.front().texts().size())
            diagnostics.error(vary.location, "together with the first <vary>, which has " +
                                                 std::to_string(p.varies.front().texts().size()) +
                                                 " values, this one needs as many; it has " +
                                                 std::to_string(vary.texts().size()));
      });
}

Spec<StudyDeck> StudyDeck::spec() {
  using P = StudyDeck;
  return Spec<P>("study", "Runs that belong together, and the report on them.")
      .attribute("title", &P::title, "What this study is.")
      .attribute("ranks", &P::ranks, at_least(1), "Ranks of each run.")
      .attribute("report", &P::report, one_of({"table", "deep-tow"}),
                 "A table and curves of what was varied; or besides, the pages of the deep-tow "
                 "study.")
      .children(&P::sweeps, required())
      .check([](const P& p, const Location&, Diagnostics& diagnostics) {
        check_names(p.sweeps, diagnostics);
      });
}

}  // namespace hawser
