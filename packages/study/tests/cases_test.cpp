#include "hawser/study/cases.hpp"

#include <gmock/gmock.h>

#include "hawser/base/error.hpp"

namespace hawser {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using Values = std::vector<std::pair<std::string, std::string>>;

std::string resolved(const std::string& deck, const Values& values) {
  std::string text = deck;
  for (const auto& [path, value] : values) {
    if (path == "unknown") throw DeckError("deck.xml:1:1: there is no 'unknown'");
    text += " " + path + "=" + value;
  }
  return text;
}

std::vector<StudyCase> cases(const std::string& inside, Diagnostics& diagnostics) {
  const Deck deck =
      parse_deck("<study title='s'>" + inside + "</study>", "folder/study.xml", diagnostics);
  const StudyDeck study = StudyDeck::spec().read(deck.root, diagnostics);
  if (!diagnostics.ok()) return {};
  return expand(study, "folder/study.xml", resolved, diagnostics);
}

std::vector<StudyCase> good_cases(const std::string& inside) {
  Diagnostics diagnostics;
  auto result = cases(inside, diagnostics);
  EXPECT_EQ(diagnostics.error_text(), "");
  return result;
}

std::string fault(const std::string& inside) {
  Diagnostics diagnostics;
  cases(inside, diagnostics);
  return diagnostics.error_text();
}

std::string sweep(const std::string& inside, const std::string& attributes = "") {
  return "<sweep name='s' deck='base.xml' " + attributes + ">" + inside + "</sweep>";
}

TEST(Cases, AreEveryCombinationTheFirstChangingSlowest) {
  const auto all =
      good_cases(sweep("<set path='end' value='9'/><vary path='U' values='0.5 m/s; 1 m/s'/>"
                       "<vary path='a' values='0 30 60'/>"));
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(all[0].folder(), "s/case_01");
  EXPECT_EQ(all[0].deck, "folder/base.xml");
  EXPECT_THAT(all[0].values, ElementsAre(Pair("end", "9"), Pair("U", "0.5 m/s"), Pair("a", "0")));
  EXPECT_THAT(all[2].values, ElementsAre(Pair("end", "9"), Pair("U", "0.5 m/s"), Pair("a", "60")));
  EXPECT_THAT(all[3].values, ElementsAre(Pair("end", "9"), Pair("U", "1 m/s"), Pair("a", "0")));
  EXPECT_EQ(all[5].title, "U = 1 m/s, a = 60");
  EXPECT_EQ(all[5].resolved, "folder/base.xml end=9 U=1 m/s a=60");
}

TEST(Cases, GoTogetherOrStandAlone) {
  const auto all =
      good_cases(sweep("<vary path='U' values='1 2'/><vary path='a' values='8 9'/>"
                       "<case name='odd' title='An odd one'><set path='b' value='3'/></case>",
                       "combine='together'"));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_THAT(all[1].values, ElementsAre(Pair("U", "2"), Pair("a", "9")));
  EXPECT_EQ(all[2].folder(), "s/odd");
  EXPECT_EQ(all[2].title, "An odd one");
  EXPECT_THAT(all[2].values, ElementsAre(Pair("b", "3")));
}

TEST(Cases, RunThroughRanges) {
  const auto texts = [](const std::string& attributes) {
    std::vector<std::string> result;
    for (const StudyCase& one : good_cases(sweep("<vary path='V' " + attributes + "/>")))
      result.push_back(one.values.back().second);
    return result;
  };
  EXPECT_THAT(texts("from='0.1' to='0.4' count='4'"), ElementsAre("0.1", "0.2", "0.3", "0.4"));
  EXPECT_THAT(texts("from='0.1' to='10' count='3' spacing='logarithmic'"),
              ElementsAre("0.1", "1", "10"));
  EXPECT_THAT(texts("from='5' to='-5' count='2'"), ElementsAre("5", "-5"));
}

TEST(Cases, BadSweepsAreToldWithTheirPlace) {
  EXPECT_EQ(fault(sweep("<vary path='V' values=';'/>")),
            "folder/study.xml:1:66: the list of values is empty");
  EXPECT_THAT(fault(sweep("<vary path='V' from='1' to='1' count='3'/>")),
              HasSubstr("study.xml:1:52: the range is empty: from and to are both 1"));
  EXPECT_THAT(fault(sweep("<vary path='V' from='1'/>")), HasSubstr("needs either values, or from"));
  EXPECT_THAT(fault(sweep("<vary path='V' from='0' to='1' count='3' spacing='logarithmic'/>")),
              HasSubstr("a logarithmic range needs positive ends"));
  EXPECT_THAT(fault(sweep("")), HasSubstr("<sweep> holds no case"));
  EXPECT_THAT(fault(sweep("<vary path='U' values='1 2'/><vary path='V' values='1'/>",
                          "combine='together'")),
              HasSubstr("which has 2 values, this one needs as many; it has 1"));
  EXPECT_THAT(fault(sweep("<case name='a/b'/>")), HasSubstr("becomes the name of a folder"));
  EXPECT_THAT(fault(sweep("<case name='a'/><case name='a'/>")), HasSubstr("is given twice"));
  EXPECT_THAT(fault(sweep("<vary path='V' values='1'/><case name='case_01'/>")),
              HasSubstr("has two cases 'case_01'"));
}

TEST(Cases, AFaultOfTheBaseDeckIsToldOnce) {
  const std::string text = fault(sweep("<vary path='unknown' values='1 2 3'/>"));
  EXPECT_EQ(text,
            "folder/study.xml:1:19: sweep 's', case_01 (unknown = 1): "
            "deck.xml:1:1: there is no 'unknown'");
}

}  // namespace
}  // namespace hawser
