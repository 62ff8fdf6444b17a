// Every parameter says all there is to know about it.
#include <gtest/gtest.h>

#include "language.hpp"

namespace hawser {
namespace {

bool is_sentence(const std::string& text) {
  return text.size() > 3 && (text.back() == '.' || text.compare(text.size() - 3, 3, "...") == 0);
}

bool bounds_numbers(const std::string& range) {
  return range.find_first_of("<>") != range.npos || range.find("from ") != range.npos ||
         range.find("any") == 0;
}

TEST(Language, EveryElementHasAMeaning) {
  for_each_element(language().root, "hawser", [](const NodeSpec& spec, const std::string& path) {
    EXPECT_TRUE(is_sentence(spec.meaning)) << path << ": " << spec.meaning;
  });
}

TEST(Language, EveryParameterHasUnitRangeDefaultAndMeaning) {
  int parameters = 0;
  for_each_element(language().root, "hawser", [&](const NodeSpec& spec, const std::string& path) {
    for (const AttributeSpec& attribute : spec.attributes) {
      const std::string where = path + "/" + attribute.name;
      ++parameters;
      EXPECT_TRUE(is_sentence(attribute.meaning)) << where << ": a meaning";
      EXPECT_TRUE(attribute.is_required || !attribute.default_text.empty() ||
                  !attribute.absent.empty())
          << where << ": a default, or absent(\"what it means to leave it out\")";
      if (!attribute.resolve) continue;  // no number
      EXPECT_TRUE(bounds_numbers(attribute.range)) << where << ": a range, or any()";
      if (attribute.type != "whole number") {
        EXPECT_FALSE(attribute.unit.empty()) << where << ": a unit, or \"1\"";
      }
    }
  });
  EXPECT_GT(parameters, 80);
}

// A formula gives SI units; so a unit that is another one is for plain numbers only.
TEST(Language, UnitsAreThoseOfSI) {
  for_each_element(language().root, "hawser", [](const NodeSpec& spec, const std::string& path) {
    for (const AttributeSpec& attribute : spec.attributes) {
      Unit unit;
      const bool free = attribute.unit == "SI" || attribute.unit.rfind("as the ", 0) == 0;
      if (attribute.unit.empty() || free) continue;
      const std::string where = path + "/" + attribute.name + " in " + attribute.unit;
      EXPECT_EQ(read_unit(attribute.unit, unit), "") << where;
      EXPECT_TRUE(unit.is_si() || (attribute.unit == "deg" && attribute.type == "number")) << where;
    }
  });
}

}  // namespace
}  // namespace hawser
